// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/body/layer_check.h"

#include <cstddef>

#include "reasoners/icarus/body/attachment_host.h"
#include "reasoners/icarus/body/term_bridge.h"
#include "reasoners/icarus/machine/interpreter.h"

namespace latchwork::icarus {

std::vector<std::string> FactsOf(const sdk::Body& body) {
  std::vector<std::string> heads;
  for (const sdk::PortSpec& port : body.contract.inputs) {
    for (const auto& predicate : port.predicates) heads.push_back(Fold(predicate.name));
  }
  for (const logic::Fact& fact : body.facts) heads.push_back(Fold(fact.predicate().name()));
  return heads;
}

Findings CheckInLayer(const Program& program, const sdk::Body& body, logic::SymbolTable& symbols) {
  NamePool names;
  TermBridge bridge(symbols, names);
  AttachmentHost host(body, bridge);
  Interpreter interpreter(program, host, names, {});
  Findings findings = interpreter.findings();
  if (interpreter.AddTop(findings) == Interpreter::kNoTop) {
    Reporter(program.source, findings)
        .AddAt(Code::kTop, 0, 1, 1, "the program does not say which call its cycles begin with",
               "add (top (Skill argument ...))");
  }
  for (std::size_t i = 0; i < program.nevers.size(); ++i) interpreter.AddNever(i, findings);
  Settle(program.source, findings);
  return findings;
}

}  // namespace latchwork::icarus

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_OMPL_REASONER_MIND_H_
#define LATCHWORK_TESTS_REASONERS_OMPL_REASONER_MIND_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/logic/tptp.h"
#include "latchwork/sdk/contract_body.h"
#include "reasoners/ompl/ompl_reasoner.h"

namespace latchwork::planning {

inline constexpr const char* kOffice =
    LATCHWORK_SOURCE_DIR "/worlds/office/data/building/building.p";

/// The reasoner with a contract that names no more than what goes out: facts in, conclusions out,
/// as texts.
class ReasonerMind {
 public:
  using Given = std::vector<std::pair<std::string, std::string>>;

  ReasonerMind(const std::vector<std::string>& conclusions, const Given& given = {},
               const std::vector<std::string>& body_facts = {}) {
    sdk::PortSpec out{.name = "out", .predicates = {}, .help = ""};
    for (const std::string& text : conclusions) {
      const logic::Fact shape = Read(text);
      std::vector<sdk::ArgumentSpec> arguments(shape.arity());
      out.predicates.push_back({std::string(shape.predicate().name()), arguments, ""});
    }
    sdk::Body body = sdk::ContractBody({{}, {out}}, "", symbols_);
    for (const std::string& text : body_facts) body.facts.push_back(Read(text));
    std::vector<sdk::Parameters::Given> parameters{{"map", kOffice, {}}};
    for (const auto& [name, value] : given) parameters.push_back({name, value, {"a.xml", 7, 1}});
    const auto checked = sdk::Parameters::Check(reasoner_.parameters(), parameters, "ompl",
                                                {"a.xml", 6, 1}, diagnostics_);
    if (!diagnostics_.empty()) return;
    diagnostics_ = reasoner_.Load(body, checked, symbols_);
  }

  const logic::Diagnostics& diagnostics() const { return diagnostics_; }
  const sdk::Decision& decision() const { return decision_; }
  sdk::Budget& budget() { return budget_; }

  /// Sorted.
  std::vector<std::string> Decide(const std::vector<std::string>& facts) {
    EXPECT_EQ(logic::Format(diagnostics_), "");
    std::vector<sdk::Latch> latches(1);
    for (const std::string& text : facts) latches[0].facts.push_back(Read(text));
    reasoner_.Decide(latches, budget_, decision_);
    std::vector<std::string> texts;
    for (const auto& conclusion : decision_.conclusions) {
      texts.push_back(logic::ToString(conclusion.fact));
    }
    std::sort(texts.begin(), texts.end());
    return texts;
  }

 private:
  logic::Fact Read(const std::string& text) {
    const auto read = logic::ReadTptpAtom(text, "test", symbols_);
    EXPECT_TRUE(read.atom.has_value()) << text;
    return read.atom.value_or(logic::Fact());
  }

  logic::SymbolTable symbols_;
  OmplReasoner reasoner_;
  sdk::Budget budget_{.inferences = 5'000'000};
  sdk::Decision decision_;
  logic::Diagnostics diagnostics_;
};

}  // namespace latchwork::planning

#endif  // LATCHWORK_TESTS_REASONERS_OMPL_REASONER_MIND_H_

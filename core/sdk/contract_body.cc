// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/contract_body.h"

#include <vector>

namespace latchwork::sdk {
namespace {

Goal GoalOf(const PredicateSpec& predicate, std::size_t port, logic::SymbolTable& symbols) {
  std::vector<logic::Term> variables;
  for (std::size_t i = 0; i < predicate.arguments.size(); ++i) {
    variables.push_back(logic::Term::Var(static_cast<logic::Variable>(i)));
  }
  return {
      {symbols.Intern(predicate.name), variables}, variables.size(), Goal::Answers::kFirst, port};
}

}  // namespace

Body ContractBody(const Contract& contract, std::string_view language,
                  logic::SymbolTable& symbols) {
  Body body;
  body.language = language;
  body.contract = contract;
  for (const PortSpec& port : contract.inputs) {
    for (const PredicateSpec& predicate : port.predicates) {
      body.inputs.push_back({symbols.Intern(predicate.name), predicate.arguments.size()});
    }
  }
  for (std::size_t port = 0; port < contract.outputs.size(); ++port) {
    for (const PredicateSpec& predicate : contract.outputs[port].predicates) {
      body.goals.push_back(GoalOf(predicate, port, symbols));
    }
  }
  return body;
}

}  // namespace latchwork::sdk

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/proof_printer.h"

#include <algorithm>

namespace latchwork::pttp {

using logic::Clause;
using logic::Formula;

void ProofPrinter::Add(const ClauseInstance& instance) {
  const Clause& clause = clauses_[instance.clause];
  Clause instantiated;
  instantiated.literals = instance.literals;
  std::string text = ToString(instantiated);
  if (known_instances_.insert(text).second) {
    instances_.emplace_back(std::move(text), tstp_.Input(clause));
    premises.push_back({instance, {}});
  }
  if (clause.role == logic::Role::kNegatedConjecture) AddAnswer(instance);
}

void ProofPrinter::AddTheoryFact(const logic::Literal& literal, std::string_view theory) {
  const std::string text = ToString(literal);
  if (!known_instances_.insert(text).second) return;
  premises.push_back({{0, {literal}, {}}, theory});
  facts_.push_back(theory == "equality" ? tstp_.Tautology(text) : tstp_.TheoryFact(text, theory));
}

void ProofPrinter::AddAnswer(const ClauseInstance& instance) {
  const auto& formulas = sources_.formulas;
  const auto conjecture = std::find_if(formulas.begin(), formulas.end(), [](const auto& formula) {
    return formula.role == logic::Role::kConjecture &&
           formula.formula.kind() == Formula::Kind::kExists;
  });
  if (conjecture == formulas.end()) return;
  const auto& names = clauses_[instance.clause].variable_names;
  std::vector<std::string> tuple;
  for (const logic::Variable variable : conjecture->formula.variables()) {
    const auto place = std::find(names.begin(), names.end(), conjecture->variable_names[variable]);
    if (place == names.end()) return;
    tuple.push_back(ToString(instance.values[static_cast<std::size_t>(place - names.begin())]));
  }
  if (std::find(answers.begin(), answers.end(), tuple) == answers.end()) {
    answers.push_back(std::move(tuple));
  }
}

void ProofPrinter::Finish() {
  // After all that brings in new symbols, as an instance may hold any of them.
  std::vector<std::string> parents = std::move(facts_);
  for (const auto& [literals, clause] : instances_) {
    parents.push_back(tstp_.Derived("instance", literals, "instantiate", {&clause, 1}));
  }
  tstp_.Derived("refutation", "$false", "resolution", parents);
  lines = tstp_.Take();
}

void ProofPrinter::Print(std::span<const saturation::Step> steps) {
  std::vector<std::string> names(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].input) names[i] = tstp_.Input(clauses_[*steps[i].input]);
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].input) continue;
    std::vector<std::string> parents;
    for (const std::size_t parent : steps[i].parents) parents.push_back(names[parent]);
    names[i] = tstp_.Derived("clause", ToString(steps[i].clause), steps[i].rule, parents);
  }
  lines = tstp_.Take();
}

}  // namespace latchwork::pttp

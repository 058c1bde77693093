// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proof_printer.h"

#include <fmt/format.h>

#include <algorithm>

namespace latchwork::pttp {

using logic::Clause;
using logic::Formula;

void ProofPrinter::AddInstance(std::string literals, std::uint32_t index) {
  if (!known_instances_.insert(literals).second) return;
  instances_.push_back({std::move(literals), tstp_.Input(engine_.program().clauses()[index])});
}

void ProofPrinter::AddTheoryFact(const logic::Literal& literal, std::string_view theory) {
  const std::string text = ToString(literal);
  if (!known_instances_.insert(text).second) return;
  facts_.push_back(theory == "equality" ? tstp_.Tautology(text) : tstp_.TheoryFact(text, theory));
}

void ProofPrinter::Instance(std::uint32_t index, const Contrapositive& rule, const Word* slots) {
  std::vector<std::string> literals;
  if (rule.has_head) {
    literals.push_back(ToString(
        logic::Literal{rule.head.positive, engine_.Instance(rule.head, slots, variables_)}));
  }
  for (const CompiledLiteral& literal : rule.body) {
    literals.push_back(
        ToString(logic::Literal{!literal.positive, engine_.Instance(literal, slots, variables_)}));
  }
  AddInstance(literals.empty() ? "$false" : fmt::format("{}", fmt::join(literals, " | ")), index);
  const Clause& clause = engine_.program().clauses()[index];
  if (clause.role == logic::Role::kNegatedConjecture) AddAnswer(clause, slots);
}

void ProofPrinter::AddAnswer(const Clause& clause, const Word* slots) {
  const auto& formulas = sources_.formulas;
  const auto conjecture = std::find_if(formulas.begin(), formulas.end(), [](const auto& formula) {
    return formula.role == logic::Role::kConjecture &&
           formula.formula.kind() == Formula::Kind::kExists;
  });
  if (conjecture == formulas.end()) return;
  std::vector<std::string> tuple;
  for (const logic::Variable variable : conjecture->formula.variables()) {
    const auto& names = clause.variable_names;
    const auto place = std::find(names.begin(), names.end(), conjecture->variable_names[variable]);
    if (place == names.end()) return;
    tuple.push_back(ToString(engine_.Value(slots[place - names.begin()], variables_)));
  }
  if (std::find(answers.begin(), answers.end(), tuple) == answers.end()) {
    answers.push_back(std::move(tuple));
  }
}

void ProofPrinter::AddFact(const logic::Atom& fact) {
  const auto& clauses = engine_.program().clauses();
  for (std::uint32_t i = 0; i < clauses.size(); ++i) {
    const auto& literals = clauses[i].literals;
    if (literals.size() != 1 || !literals[0].positive || literals[0].atom != fact) continue;
    return AddInstance(ToString(fact), i);
  }
}

void ProofPrinter::AddStep(const Step& step) {
  const logic::Literal literal{step.node->literal->positive,
                               engine_.Instance(*step.node, variables_)};
  switch (step.kind) {
    case Step::Kind::kRule:
      Instance(step.rule->clause, *step.rule, step.slots);
      break;
    case Step::Kind::kFact:
      AddFact(literal.atom);
      break;
    case Step::Kind::kEquality:
      AddTheoryFact(literal, "equality");
      break;
    case Step::Kind::kArithmetic:
    case Step::Kind::kAttachment:
    case Step::Kind::kAssumption:
      AddTheoryFact(literal, "arithmetic");
      break;
    case Step::Kind::kReduction:
      break;
  }
}

void ProofPrinter::Print(const Proof& proof) {
  Instance(proof.start->clause, *proof.start, proof.slots);
  std::vector<const Step*> steps;
  for (const Step* step = proof.steps; step != nullptr; step = step->previous) {
    steps.push_back(step);
  }
  std::reverse(steps.begin(), steps.end());
  for (const Step* step : steps) AddStep(*step);
  // After all that brings in new symbols, as an instance may hold any of them.
  std::vector<std::string> premises = std::move(facts_);
  for (const auto& [literals, clause] : instances_) {
    premises.push_back(tstp_.Derived("instance", literals, "instantiate", {&clause, 1}));
  }
  tstp_.Derived("refutation", "$false", "resolution", premises);
  lines = tstp_.Take();
}

}  // namespace latchwork::pttp

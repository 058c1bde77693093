// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/proof_printer.h"

#include <algorithm>
#include <map>
#include <utility>

#include "reasoners/pttp/proofs/unit_chain.h"

namespace latchwork::pttp {

using logic::Clause;
using logic::Formula;

namespace {

/// That one step may have; more make a chain of steps.
constexpr std::size_t kMostParents = 16;

std::string Text(std::vector<logic::Literal> literals) {
  Clause clause;
  clause.literals = std::move(literals);
  return ToString(clause);
}

}  // namespace

void ProofPrinter::Add(const ClauseInstance& instance) {
  const Clause& clause = clauses_[instance.clause];
  if (known_instances_.insert(Text(instance.literals)).second) {
    instances_.push_back({tstp_.Input(clause), instance.literals});
    premises.push_back({instance, {}});
  }
  if (clause.role == logic::Role::kNegatedConjecture) AddAnswer(instance);
}

void ProofPrinter::AddTheoryFact(const std::vector<logic::Literal>& literals,
                                 std::string_view theory) {
  const std::string text = Text(literals);
  if (!known_instances_.insert(text).second) return;
  premises.push_back({{0, literals, {}}, theory});
  facts_.push_back(
      {theory == "equality" ? tstp_.Tautology(text) : tstp_.TheoryFact(text, theory), literals});
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
  std::vector<Premise> all = std::move(facts_);
  for (Premise& each : instances_) {
    each.name = tstp_.Derived("instance", Text(each.literals), "instantiate", {&each.name, 1});
    all.push_back(std::move(each));
  }
  PrintChain(all);
  lines = tstp_.Take();
}

void ProofPrinter::PrintChain(const std::vector<Premise>& all) {
  std::map<logic::Atom, PropositionalLiteral> numbers;
  std::vector<logic::Atom> atoms;
  std::vector<PropositionalClause> clauses;
  std::vector<std::string> names;
  for (const Premise& each : all) {
    names.push_back(each.name);
    PropositionalClause& clause = clauses.emplace_back();
    for (const logic::Literal& literal : each.literals) {
      const auto next = static_cast<PropositionalLiteral>(2 * atoms.size());
      const auto [place, is_new] = numbers.emplace(literal.atom, next);
      if (is_new) atoms.push_back(literal.atom);
      clause.push_back(place->second + (literal.positive ? 0 : 1));
    }
  }
  std::optional<std::vector<ChainStep>> chain;
  if (all.size() > kMostParents) chain = UnitChain(clauses, {.parents = kMostParents});
  if (!chain) {
    tstp_.Derived("refutation", "$false", "resolution", names);
    return;
  }
  for (const ChainStep& step : *chain) {
    std::vector<logic::Literal> literals;
    for (const PropositionalLiteral each : step.clause) {
      literals.push_back({(each & 1U) == 0, atoms[each / 2]});
    }
    std::vector<std::string> parents;
    for (const std::size_t parent : step.parents) parents.push_back(names[parent]);
    names.push_back(tstp_.Derived("refutation", Text(literals), "resolution", parents));
  }
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

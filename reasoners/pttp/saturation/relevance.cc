// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/relevance.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>

#include "latchwork/logic/symbol.h"

namespace latchwork::pttp::saturation {
namespace {

using SymbolSet = std::set<std::size_t>;

/// A formula's clauses are used together.
struct Formula {
  std::vector<std::size_t> clauses;
  SymbolSet symbols;
  bool goal = false;
  bool selected = false;
};

SymbolSet SymbolsOf(const logic::Clause& clause) {
  SymbolSet symbols;
  std::vector<const logic::Term*> visits;
  for (const logic::Literal& literal : clause.literals) {
    if (literal.atom.predicate().name() != "=") symbols.insert(literal.atom.predicate().index());
    for (const logic::Term& term : literal.atom.arguments()) visits.push_back(&term);
  }
  while (!visits.empty()) {
    const logic::Term& term = *visits.back();
    visits.pop_back();
    if (term.is_variable() || term.is_number()) continue;
    symbols.insert(term.symbol().index());
    for (const logic::Term& argument : term.arguments()) visits.push_back(&argument);
  }
  return symbols;
}

std::vector<Formula> Group(std::span<const logic::Clause> clauses) {
  std::vector<Formula> formulas;
  std::map<std::string_view, std::size_t> by_name;
  for (std::size_t i = 0; i < clauses.size(); ++i) {
    const auto [at, is_new] = by_name.try_emplace(clauses[i].name, formulas.size());
    if (is_new) formulas.emplace_back();
    Formula& formula = formulas[at->second];
    formula.clauses.push_back(i);
    formula.symbols.merge(SymbolsOf(clauses[i]));
    formula.goal = formula.goal || clauses[i].role == logic::Role::kNegatedConjecture;
  }
  return formulas;
}

/// For each symbol, the formulas that it brings in.
std::map<std::size_t, std::vector<std::size_t>> Triggers(const std::vector<Formula>& formulas,
                                                         unsigned tolerance) {
  std::map<std::size_t, std::size_t> occurrences;
  for (const Formula& formula : formulas) {
    for (const std::size_t symbol : formula.symbols) ++occurrences[symbol];
  }
  std::map<std::size_t, std::vector<std::size_t>> triggers;
  for (std::size_t i = 0; i < formulas.size(); ++i) {
    std::size_t rarest = formulas.size();
    for (const std::size_t symbol : formulas[i].symbols) {
      rarest = std::min(rarest, occurrences[symbol]);
    }
    for (const std::size_t symbol : formulas[i].symbols) {
      if (occurrences[symbol] <= rarest * tolerance) triggers[symbol].push_back(i);
    }
  }
  return triggers;
}

}  // namespace

std::vector<bool> SelectRelevant(std::span<const logic::Clause> clauses, unsigned depth,
                                 unsigned tolerance) {
  std::vector<Formula> formulas = Group(clauses);
  const auto triggers = Triggers(formulas, tolerance);
  SymbolSet reached;
  std::vector<std::size_t> frontier;
  for (std::size_t i = 0; i < formulas.size(); ++i) {
    if (formulas[i].goal) frontier.push_back(i);
    // Nothing could bring in a formula without symbols (X = Y).
    formulas[i].selected = formulas[i].goal || formulas[i].symbols.empty();
  }
  if (frontier.empty()) {
    std::vector<bool> all(clauses.size(), true);
    return all;
  }
  for (unsigned step = 0; step < depth && !frontier.empty(); ++step) {
    std::vector<std::size_t> next;
    for (const std::size_t from : frontier) {
      for (const std::size_t symbol : formulas[from].symbols) {
        const auto brings = triggers.find(symbol);
        if (!reached.insert(symbol).second || brings == triggers.end()) continue;
        for (const std::size_t to : brings->second) {
          if (!formulas[to].selected) next.push_back(to);
          formulas[to].selected = true;
        }
      }
    }
    frontier = std::move(next);
  }
  std::vector<bool> selected(clauses.size(), false);
  for (const Formula& formula : formulas) {
    for (const std::size_t clause : formula.clauses) selected[clause] = formula.selected;
  }
  return selected;
}

}  // namespace latchwork::pttp::saturation

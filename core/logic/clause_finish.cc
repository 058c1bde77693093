// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <unordered_set>
#include <utility>

#include "core/logic/clause_maker.h"
#include "core/logic/print.h"
#include "core/logic/rebuild_term.h"

namespace latchwork::logic {

std::optional<Clause> ClauseMaker::Finish(const LiteralIndices& indices, const Clause& pattern) {
  if (IsTautology(indices)) return std::nullopt;
  Clause clause = pattern;
  for (const Variable variable : numbered_) numbers_[variable].reset();
  numbered_.clear();
  numbers_.resize(sources_.size());
  for (const std::uint32_t index : WithoutRepetition(indices)) {
    const Literal& literal = literals_[index];
    clause.literals.push_back({literal.positive, Renumber(literal.atom)});
    if (work_.is_spent()) return std::nullopt;
  }
  clause.variable_names = Names();
  return clause;
}

bool ClauseMaker::IsTautology(const LiteralIndices& indices) const {
  LiteralIndices sorted = indices;
  std::sort(sorted.begin(), sorted.end(), [this](std::uint32_t a, std::uint32_t b) {
    const Literal& x = literals_[a];
    const Literal& y = literals_[b];
    const auto by_atom = x.atom <=> y.atom;
    return std::is_neq(by_atom) ? std::is_lt(by_atom) : x.positive < y.positive;
  });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const Literal& literal = literals_[sorted[i]];
    const Atom& atom = literal.atom;
    if (literal.positive && IsEquation(atom) && atom.argument(0) == atom.argument(1)) return true;
    if (i == 0) continue;
    const Literal& before = literals_[sorted[i - 1]];
    if (before.positive != literal.positive && before.atom == atom) return true;
  }
  return false;
}

/// The first of equal literals stays.
LiteralIndices ClauseMaker::WithoutRepetition(const LiteralIndices& indices) const {
  std::vector<std::size_t> order(indices.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return literals_[indices[a]] < literals_[indices[b]];
  });
  std::vector<bool> is_repeated(indices.size());
  for (std::size_t i = 1; i < order.size(); ++i) {
    is_repeated[order[i]] = literals_[indices[order[i]]] == literals_[indices[order[i - 1]]];
  }
  LiteralIndices kept;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (!is_repeated[i]) kept.push_back(indices[i]);
  }
  return kept;
}

/// Numbers variables in the order in which they occur.
Atom ClauseMaker::Renumber(const Atom& atom) {
  work_.Spend(atom.arity() + 1);
  if (atom.is_ground()) return atom;
  const auto replace = [&](const Term& term) -> std::optional<Term> {
    if (term.is_ground()) return term;
    if (!term.is_variable()) return std::nullopt;
    auto& number = numbers_[term.variable()];
    if (!number) {
      number = static_cast<Variable>(numbered_.size());
      numbered_.push_back(term.variable());
    }
    return Term::Var(*number);
  };
  const auto join = [this](Symbol symbol, std::vector<Term> rebuilt) -> std::optional<Term> {
    work_.Spend(rebuilt.size());
    return Term::Compound(symbol, std::move(rebuilt));
  };
  std::vector<Term> arguments;
  for (const Term& term : atom.arguments()) arguments.push_back(*RebuildTerm(term, replace, join));
  return {atom.predicate(), arguments};
}

std::vector<std::string> ClauseMaker::Names() const {
  std::vector<std::string> names;
  std::unordered_set<std::string> taken;
  for (const Variable variable : numbered_) {
    const Variable source = sources_[variable];
    const bool is_named = source < variable_names_.size() && !variable_names_[source].empty();
    const std::string stem =
        is_named ? variable_names_[source] : "X" + std::to_string(names.size());
    std::string name = stem;
    for (std::size_t n = names.size(); !taken.insert(name).second; ++n) {
      name = stem + "_" + std::to_string(n);
    }
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace latchwork::logic

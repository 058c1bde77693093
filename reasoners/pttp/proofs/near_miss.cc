// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/near_miss.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "reasoners/pttp/proofs/instances.h"

namespace latchwork::pttp {
namespace {

using logic::Clause;
using logic::Literal;

constexpr std::size_t kMostCandidates = 20'000;

/// How well a conclusion agrees with the goal.
struct Fit {
  std::vector<bool> fits;  ///< By argument, those before it that fit having been unified.
  std::size_t first_miss = 0;
  std::string miss;
};

std::string Text(const Instances& instances, TermCopy term) {
  Instances::Numbers numbers;
  const auto exported = instances.Export(term, numbers);
  return exported ? ToString(*exported) : "too large";
}

/// The variables of an exported goal are numbered from 0.
std::size_t VariableCount(const Literal& goal) {
  std::size_t count = 0;
  std::vector<const logic::Term*> visits;
  for (const logic::Term& argument : goal.atom.arguments()) visits.push_back(&argument);
  while (!visits.empty()) {
    const logic::Term& term = *visits.back();
    visits.pop_back();
    if (term.is_variable()) count = std::max(count, std::size_t{term.variable()} + 1);
    for (const logic::Term& argument : term.arguments()) visits.push_back(&argument);
  }
  return count;
}

Fit Compare(const Literal& goal, std::size_t goal_variables, const Clause& clause,
            const Literal& conclusion) {
  Instances instances;
  const std::uint32_t goal_base = instances.Copy(goal_variables);
  const std::uint32_t base = instances.Copy(clause.variable_names.size());
  Fit fit;
  for (std::size_t i = 0; i < goal.atom.arity(); ++i) {
    const TermCopy wanted{&goal.atom.argument(i), goal_base};
    const TermCopy given{&conclusion.atom.argument(i), base};
    const Instances::Mark mark = instances.mark();
    fit.fits.push_back(instances.Unify(given, wanted));
    if (fit.fits.back()) continue;
    instances.UndoTo(mark);
    if (!fit.miss.empty()) continue;
    fit.first_miss = i;
    fit.miss = fmt::format("argument {} is {}, wanted {}", i + 1, Text(instances, given),
                           Text(instances, wanted));
  }
  return fit;
}

std::ptrdiff_t CountFits(const Fit& fit) { return std::ranges::count(fit.fits, true); }

}  // namespace

std::optional<std::string> NearMiss(const Literal& goal, const ClauseIndex& index) {
  const auto places = index.Find(KeyOf(goal));
  if (places.empty()) return std::nullopt;
  const std::size_t variables = VariableCount(goal);
  const LiteralPlace* best = nullptr;
  Fit best_fit;
  std::vector<bool> ever(goal.atom.arity(), places.size() > kMostCandidates);
  for (const LiteralPlace& place : places.first(std::min(places.size(), kMostCandidates))) {
    Fit fit = Compare(goal, variables, index.clauses()[place.clause], index.literal(place));
    for (std::size_t i = 0; i < ever.size(); ++i) ever[i] = ever[i] || fit.fits[i];
    if (best != nullptr && CountFits(fit) <= CountFits(best_fit)) continue;
    best = &place;
    best_fit = std::move(fit);
  }
  if (best_fit.miss.empty()) return std::nullopt;
  const Clause& clause = index.clauses()[best->clause];
  return fmt::format(
      "nearest {} of {}: {}{}", ToString(index.literal(*best), clause.variable_names), clause.name,
      best_fit.miss, ever[best_fit.first_miss] ? "" : ", which no conclusion has there");
}

}  // namespace latchwork::pttp

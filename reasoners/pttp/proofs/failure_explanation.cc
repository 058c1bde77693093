// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/failure_explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "latchwork/logic/diagnostic.h"
#include "reasoners/pttp/proofs/clause_index.h"
#include "reasoners/pttp/proofs/computed_conclusions.h"
#include "reasoners/pttp/proofs/near_miss.h"
#include "reasoners/pttp/proofs/partial_attempts.h"

namespace latchwork::pttp {
namespace {

using logic::Clause;
using logic::Literal;
using logic::Role;

constexpr std::uint64_t kMostWork = 4'000'000;
constexpr std::size_t kMostClauses = 200'000;
constexpr std::size_t kMostShown = 5;
constexpr std::size_t kMostAboveShown = 4;

std::string EndOf(const ProverResult& result, const ProverOptions& options) {
  switch (result.status) {
    case Szs::kCounterSatisfiable:
      return fmt::format(
          "Everything was searched (strategy {}): the other formulas allow it to be false.",
          result.strategy);
    case Szs::kSatisfiable:
      return fmt::format("Everything was searched (strategy {}): there is no contradiction.",
                         result.strategy);
    case Szs::kTimeout:
      return fmt::format("The search was stopped before its end; it had {} s (--time).",
                         options.cpu_seconds);
    case Szs::kResourceOut:
      return result.statistics.inferences >= options.budget.inferences
                 ? fmt::format("The search ended at its bound of {} inferences (--inferences).",
                               options.budget.inferences)
                 : "The search ended for lack of memory (--memory).";
    default:
      break;
  }
  if (result.statistics.depth >= options.budget.depth) {
    return fmt::format("The search ended at its bound on depth, {} (--depth).",
                       options.budget.depth);
  }
  return "The strategies that ran came to their end; they cannot tell that there is no proof.";
}

bool IsInterpreted(std::string_view name) { return name == "=" || name.starts_with('$'); }

/// What the conjecture consists of; without one, every clause without a positive literal.
std::vector<std::uint32_t> Starts(std::span<const Clause> clauses) {
  std::vector<std::uint32_t> of_goal;
  std::vector<std::uint32_t> negative;
  for (std::uint32_t i = 0; i < clauses.size(); ++i) {
    if (clauses[i].role == Role::kNegatedConjecture) of_goal.push_back(i);
    if (std::ranges::none_of(clauses[i].literals, [](const Literal& l) { return l.positive; })) {
      negative.push_back(i);
    }
  }
  return of_goal.empty() ? negative : of_goal;
}

/// The goals that backward steps can reach, by key, each with the clause that first asked for it.
std::map<LiteralKey, std::uint32_t> Reach(const ClauseIndex& index,
                                          std::span<const std::uint32_t> starts) {
  std::map<LiteralKey, std::uint32_t> reached;
  std::vector<LiteralKey> queue;
  const auto open = [&](std::uint32_t clause, std::size_t without) {
    const auto& literals = index.clauses()[clause].literals;
    for (std::size_t i = 0; i < literals.size(); ++i) {
      const LiteralKey key = KeyOf(ComplementOf(literals[i]));
      if (i != without && reached.emplace(key, clause).second) queue.push_back(key);
    }
  };
  for (const std::uint32_t start : starts) open(start, index.clauses()[start].literals.size());
  std::size_t next = 0;
  while (next < queue.size()) {
    const LiteralKey key = queue[next++];
    for (const LiteralPlace& place : index.Find(key)) open(place.clause, place.literal);
  }
  return reached;
}

/// What a predicate that nothing concludes may have been meant to be.
std::string MeantPredicate(const LiteralKey& key, const ClauseIndex& index) {
  std::vector<std::string> names;
  for (const auto& [known, places] : index.places()) {
    if (known.positive != key.positive) continue;
    if (known.name.symbol == key.name.symbol) {
      return fmt::format(" ({} concludes {})", index.clauses()[places.front().clause].name,
                         ToString(known.name));
    }
    if (!IsInterpreted(known.name.symbol.name())) names.emplace_back(known.name.symbol.name());
  }
  const std::string_view meant = logic::NearestName(key.name.symbol.name(), names);
  return meant.empty() ? "" : fmt::format(" (did you mean {}?)", logic::QuoteWord(meant));
}

std::set<LiteralKey> AddMissing(const ClauseIndex& index, std::span<const std::uint32_t> starts,
                                Explanation& lines) {
  const auto reached = Reach(index, starts);
  std::set<LiteralKey> missing;
  for (const auto& [key, clause] : reached) {
    const bool can_reduce = reached.contains({key.name, !key.positive});
    if (IsInterpreted(key.name.symbol.name()) || !index.Find(key).empty() || can_reduce) continue;
    if (missing.size() < kMostShown) {
      lines.push_back({0, fmt::format("No formula {} {}, which {} needs{}.",
                                      key.positive ? "concludes" : "denies", ToString(key.name),
                                      index.clauses()[clause].name, MeantPredicate(key, index))});
    }
    missing.insert(key);
  }
  return missing;
}

using Functors = std::map<logic::PredicateName, std::uint32_t>;  ///< With a clause that has it.

void Collect(const Clause& clause, std::uint32_t number, Functors& functors) {
  std::vector<const logic::Term*> visits;
  for (const Literal& literal : clause.literals) {
    for (const logic::Term& argument : literal.atom.arguments()) visits.push_back(&argument);
  }
  while (!visits.empty()) {
    const logic::Term& term = *visits.back();
    visits.pop_back();
    if (term.is_variable() || term.is_number()) continue;
    functors.emplace(logic::PredicateName{term.symbol(), term.arguments().size()}, number);
    for (const logic::Term& argument : term.arguments()) visits.push_back(&argument);
  }
}

/// Constants and functions of the conjecture alone whose names are almost those of others.
void AddUnknownNames(std::span<const Clause> clauses, Explanation& lines) {
  Functors of_goal;
  Functors others;
  for (std::uint32_t i = 0; i < clauses.size(); ++i) {
    Collect(clauses[i], i, clauses[i].role == Role::kNegatedConjecture ? of_goal : others);
  }
  std::vector<std::string> names;
  for (const auto& [name, clause] : others) names.emplace_back(name.symbol.name());
  for (const auto& [name, clause] : of_goal) {
    if (others.contains(name)) continue;
    const std::string_view meant = logic::NearestName(name.symbol.name(), names);
    if (meant.empty()) continue;
    lines.push_back({0, fmt::format("{} occurs in {} alone (did you mean {}?).",
                                    logic::QuoteWord(name.symbol.name()), clauses[clause].name,
                                    logic::QuoteWord(meant))});
  }
}

std::string AboveOf(const DeadEnd& dead_end) {
  std::vector<std::string> texts;
  for (const Literal& literal : dead_end.above) {
    if (texts.size() == kMostAboveShown) break;
    texts.push_back(Shorten(ToString(literal)));
  }
  return fmt::format("{}{}", fmt::join(texts, ", for "),
                     dead_end.above.size() > kMostAboveShown ? ", ..." : "");
}

void AddDeadEnd(const DeadEnd& dead_end, const ClauseIndex& index, Explanation& lines) {
  const std::string_view predicate = dead_end.goal.atom.predicate().name();
  const std::string goal = Shorten(ToString(dead_end.goal));
  if (const auto miss = NearMiss(dead_end.goal, index)) {
    lines.push_back({1, fmt::format("no clause concludes {}: {}", goal, Shorten(*miss))});
  } else {
    lines.push_back(
        {1, fmt::format("{} {}",
                        IsInterpreted(predicate) ? "nothing makes true" : "no clause concludes",
                        goal)});
  }
  if (!dead_end.above.empty()) {
    lines.push_back({2, fmt::format("needed for {}", AboveOf(dead_end))});
  }
  if (dead_end.open > 0) {
    lines.push_back(
        {2, fmt::format("{} other goal{} left", dead_end.open, dead_end.open == 1 ? "" : "s")});
  }
}

void AddAttempts(const PartialAttempts& attempts, const std::set<LiteralKey>& missing,
                 const ClauseIndex& index, Explanation& lines) {
  std::vector<const DeadEnd*> shown;
  for (const DeadEnd& dead_end : attempts.dead_ends) {
    if (shown.size() == kMostShown) break;
    const bool is_said = missing.contains(KeyOf(dead_end.goal)) && dead_end.above.empty();
    if (!is_said) shown.push_back(&dead_end);
  }
  if (shown.empty()) return;
  lines.push_back({0, "Where attempts ended, those nearest to a proof first:"});
  for (const DeadEnd* dead_end : shown) AddDeadEnd(*dead_end, index, lines);
}

bool ConcludesEquation(const ClauseIndex& index) {
  return std::ranges::any_of(index.places(), [](const auto& entry) {
    return entry.first.positive && entry.first.name.symbol.name() == "=";
  });
}

}  // namespace

Explanation ExplainFailure(const ProverResult& result, const ProverOptions& options,
                           logic::SymbolTable& symbols) {
  Explanation lines{{0, EndOf(result, options)}};
  if (result.theory.empty()) return lines;
  if (result.theory.size() > kMostClauses) {
    lines.push_back({0, "There are too many formulas to look for what is missing."});
    return lines;
  }
  const std::vector<Clause> clauses = WithComputedConclusions(result.theory, symbols);
  const ClauseIndex index(clauses);
  const std::vector<std::uint32_t> starts = Starts(clauses);
  if (starts.empty()) {
    lines.push_back({0, "There is no conjecture, and no formula denies anything."});
    return lines;
  }
  const std::set<LiteralKey> missing = AddMissing(index, starts, lines);
  AddUnknownNames(clauses, lines);
  const PartialAttempts attempts = TryToProve(index, starts, symbols, kMostWork);
  if (attempts.found_proof) {
    lines.push_back({0, "There is a proof: a short search with other limits finds it."});
    return lines;
  }
  AddAttempts(attempts, missing, index, lines);
  if (attempts.cut_off) lines.push_back({0, "There are more attempts than were looked at here."});
  if (ConcludesEquation(index)) {
    lines.push_back({0, "For these attempts, equations were matched as they stand only."});
  }
  return lines;
}

}  // namespace latchwork::pttp

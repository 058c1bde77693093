// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <functional>
#include <utility>

#include "apps/latchwork/diff_theory.h"

namespace latchwork::app {
namespace {

using Test = std::function<bool(const DiffTheory&)>;

/// Leaves out what can be left out of a list, in ever smaller pieces. True: some could.
template <typename List>
bool ShrinkList(DiffTheory& theory, List& (*list)(DiffTheory&, std::size_t), std::size_t index,
                const Test& still_fails) {
  bool shrunk = false;
  std::size_t piece = std::max<std::size_t>(1, list(theory, index).size() / 2);
  for (;;) {
    for (std::size_t begin = 0; begin < list(theory, index).size();) {
      DiffTheory smaller = theory;
      List& items = list(smaller, index);
      const std::size_t end = std::min(begin + piece, items.size());
      items.erase(items.begin() + static_cast<std::ptrdiff_t>(begin),
                  items.begin() + static_cast<std::ptrdiff_t>(end));
      if (still_fails(smaller)) {
        theory = std::move(smaller);
        shrunk = true;
      } else {
        begin = end;
      }
    }
    if (piece == 1) return shrunk;
    piece /= 2;
  }
}

std::vector<logic::Clause>& ClausesOf(DiffTheory& theory, std::size_t) { return theory.clauses; }
std::vector<logic::Fact>& FactsOf(DiffTheory& theory, std::size_t latch) {
  return theory.latches[latch].facts;
}
std::vector<logic::Fact>& GivenOf(DiffTheory& theory, std::size_t) { return theory.body.facts; }
std::vector<sdk::Goal>& GoalsOf(DiffTheory& theory, std::size_t) { return theory.body.goals; }
std::vector<sdk::Minimized>& MinimizedOf(DiffTheory& theory, std::size_t) {
  return theory.body.minimized;
}
std::vector<logic::Literal>& LiteralsOf(DiffTheory& theory, std::size_t clause) {
  return theory.clauses[clause].literals;
}

bool ShrinkOnce(DiffTheory& theory, const Test& still_fails) {
  bool shrunk = ShrinkList(theory, ClausesOf, 0, still_fails);
  for (std::size_t i = 0; i < theory.latches.size(); ++i) {
    shrunk = ShrinkList(theory, FactsOf, i, still_fails) || shrunk;
  }
  shrunk = ShrinkList(theory, GivenOf, 0, still_fails) || shrunk;
  shrunk = ShrinkList(theory, GoalsOf, 0, still_fails) || shrunk;
  shrunk = ShrinkList(theory, MinimizedOf, 0, still_fails) || shrunk;
  for (std::size_t i = 0; i < theory.clauses.size(); ++i) {
    shrunk = ShrinkList(theory, LiteralsOf, i, still_fails) || shrunk;
  }
  return shrunk;
}

}  // namespace

DiffTheory Shrink(const DiffTheory& theory, const Contender& a, const Contender& b,
                  logic::SymbolTable& symbols, const std::filesystem::path& folder) {
  const Test still_fails = [&](const DiffTheory& candidate) {
    const bool is_empty = std::ranges::any_of(
        candidate.clauses, [](const logic::Clause& clause) { return clause.literals.empty(); });
    if (is_empty || candidate.body.goals.empty()) return false;
    const Verdict first = Judge(a, candidate, symbols, folder);
    return first.kind == Verdict::Kind::kDecided &&
           Disagree(first, Judge(b, candidate, symbols, folder));
  };
  DiffTheory smallest = theory;
  while (ShrinkOnce(smallest, still_fails)) {
  }
  return smallest;
}

}  // namespace latchwork::app

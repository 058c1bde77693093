// SPDX-License-Identifier: BSD-3-Clause
// Queries that are asked again and again: what is known about them, and how they are solved.
#include "reasoners/pttp/search/engine.h"

namespace latchwork::pttp {

bool Engine::Prepare(Query& query) {
  if (query.reach_version != reach_version_) {
    query.request.starts.assign(1, &query.clause);
    KnownReach& known = FindReachFor(query.request.starts, query.closing);
    query.request.reach = query.reach = &known.reach;
    query.program = known.program.get();
    query.plan_space = known.plan_space.get();
    if (query.plan_space != nullptr) query.use = query.plan_space->rules().UseOf(query.clause);
    query.fits =
        known.program->fits() && known.program->PlanQuery(query.clause, query.is_given, query.plan);
    query.reach_version = reach_version_;
  }
  seen_.AddAll(query.reach->sees);
  asks_ = asks_ || query.reach->asks;
  return query.reach->viable;
}

std::optional<SearchEnd> Engine::SolveByTables(Query& query, std::span<const Word> given,
                                               ProofSink& sink) {
  if (!query.fits || !query.program->fits()) return std::nullopt;
  const auto end = tables_.Solve(*query.program, query.plan, given, sink);
  if (!end) query.program->GiveUp();
  return end;
}

SearchEnd Engine::SolveBySearch(Query& query, std::uint32_t depth, bool record, ProofSink& sink) {
  query.request.depth = depth;
  query.request.record = record;
  return Search(query.request, sink);
}

SearchEnd Engine::Solve(Query& query, Wanted wanted, std::uint32_t depth, ProofSink& sink) {
  if (!Prepare(query)) return SearchEnd::kExhausted;
  if (const auto end = SolveBySituations(query, wanted, depth, false, sink)) return *end;
  // The first proof of a recursive goal is the shallowest one, which tables do not know.
  const bool search_first = wanted == Wanted::kFirst && query.reach->recursive;
  if (!search_first) {
    if (const auto end = SolveByTables(query, {}, sink)) return *end;
  }
  const SearchEnd end = SolveBySearch(query, depth, false, sink);
  if (!search_first || end != SearchEnd::kDepth) return end;
  return SolveByTables(query, {}, sink).value_or(end);
}

SearchEnd Engine::SolveWithSteps(Query& query, std::uint32_t depth, ProofSink& sink) {
  if (!Prepare(query)) return SearchEnd::kExhausted;
  const auto end = SolveBySituations(query, Wanted::kFirst, depth, true, sink);
  return end ? *end : SolveBySearch(query, depth, true, sink);
}

void Engine::Watch() {
  seen_.Clear();
  asks_ = false;
  asked_assumptions_.clear();
}

PredicateSet& Engine::Seen() {
  // Oracles keep their results for the decision, whoever asked first.
  if (asks_) seen_.AddAll(nested_seen_);
  return seen_;
}

bool Engine::HasChanged(const PredicateSet& seen, std::uint64_t since) const {
  return seen.Any([&](PredicateId predicate) { return facts_.ChangedSince(predicate, since); });
}

std::size_t Engine::Adopt(const sdk::Assumption& assumption) {
  for (std::size_t i = 0; i < assumptions_.size(); ++i) {
    if (assumptions_[i].atom == assumption.atom) return i;
  }
  assumptions_.push_back(assumption);
  adopted_ = assumptions_.size();
  return assumptions_.size() - 1;
}

}  // namespace latchwork::pttp

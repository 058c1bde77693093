// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/contrapositives/signed_graph.h"

#include <algorithm>
#include <utility>

namespace latchwork::contrapositives {

SignedGraph::SignedGraph(std::vector<Rule> rules, std::vector<Predicate> predicates)
    : rules_(std::move(rules)), predicates_(std::move(predicates)) {
  do {
    Connect();
    MarkReachable();
    MarkMeeting();
  } while (DropDeadRules());
  const std::size_t count = predicates_.size();
  deep_.assign(count, false);
  independent_.assign(count, true);
  std::vector<std::vector<bool>> below;
  for (Signed key = 0; key < count; ++key) below.push_back(Below(key));
  for (Signed key = 0; key < count; ++key) {
    independent_[key] = !meets_[key];
    deep_[key] = below[key][key];
    for (Signed other = 0; other < count; ++other) {
      if (!below[key][other]) continue;
      deep_[key] = deep_[key] || below[other][other];
      independent_[key] = independent_[key] && !meets_[other];
    }
  }
}

void SignedGraph::Connect() {
  successors_.assign(predicates_.size(), {});
  for (const Rule& rule : rules_) {
    if (rule.is_alive) successors_[rule.head].push_back(&rule);
  }
}

std::vector<bool> SignedGraph::Below(Signed key) const {
  std::vector<bool> seen(predicates_.size(), false);
  std::vector<Signed> open = {key};
  while (!open.empty()) {
    const Signed current = open.back();
    open.pop_back();
    for (const Rule* rule : successors_[current]) {
      for (const Signed next : rule->body) {
        if (seen[next]) continue;
        seen[next] = true;
        open.push_back(next);
      }
    }
  }
  return seen;
}

void SignedGraph::MarkReachable() {
  reachable_.assign(predicates_.size(), false);
  for (Signed key = 0; key < predicates_.size(); ++key) {
    if (!predicates_[key].is_root || reachable_[key]) continue;
    reachable_[key] = true;
    const std::vector<bool> below = Below(key);
    for (Signed other = 0; other < below.size(); ++other) {
      reachable_[other] = reachable_[other] || below[other];
    }
  }
}

void SignedGraph::MarkMeeting() {
  meets_.assign(predicates_.size(), false);
  for (Signed key = 0; key < predicates_.size(); ++key) {
    if (!reachable_[key] || !reachable_[ComplementOf(key)]) continue;
    meets_[key] = Below(ComplementOf(key))[key];
  }
}

bool SignedGraph::DropDeadRules() {
  std::vector<bool> possible(predicates_.size(), false);
  for (Signed key = 0; key < possible.size(); ++key) {
    possible[key] = predicates_[key].is_given || meets_[key];
  }
  const auto is_possible = [&](const Rule& rule) {
    return std::ranges::all_of(rule.body, [&](Signed key) { return possible[key]; });
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (const Rule& rule : rules_) {
      if (!rule.is_alive || possible[rule.head] || !is_possible(rule)) continue;
      possible[rule.head] = changed = true;
    }
  }
  bool dropped = false;
  for (Rule& rule : rules_) {
    if (!rule.is_alive || (reachable_[rule.head] && is_possible(rule))) continue;
    rule.is_alive = false;
    dropped = true;
  }
  return dropped;
}

}  // namespace latchwork::contrapositives

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/theory/reach.h"

#include <algorithm>

namespace latchwork::pttp {
namespace {

std::uint32_t SignedOf(const CompiledLiteral& literal) {
  return Signed(literal.predicate, literal.positive);
}

class ReachFinder {
 public:
  ReachFinder(const Program& program, const Predicates& predicates,
              std::span<const Contrapositive* const> starts, bool closing)
      : predicates_(predicates), starts_(starts), count_(2 * predicates.size()) {
    reach_.closing = closing;
    reach_.rules.resize(count_);
    for (std::uint32_t key = 0; key < count_; ++key) {
      for (const Contrapositive& rule : program.rules(key)) reach_.rules[key].push_back(&rule);
    }
  }

  Reach Find() {
    MarkClosing();
    do {
      MarkReachable();
      MarkMeeting();
      MarkProvable();
    } while (DropDeadRules());
    Summarize();
    return std::move(reach_);
  }

 private:
  /// While all rules are there: which of them are of use may depend on closing as well.
  void MarkClosing() {
    std::vector<bool>& closes = reach_.closes;
    closes.assign(count_, false);
    for (std::uint32_t key = 0; key < count_; key += 2) {
      closes[key] = predicates_[key / 2].minimized.has_value();
    }
    const auto leads_there = [&](const Contrapositive* rule) {
      return std::any_of(rule->body.begin(), rule->body.end(),
                         [&](const CompiledLiteral& literal) { return closes[SignedOf(literal)]; });
    };
    for (bool changed = true; changed;) {
      changed = false;
      for (std::uint32_t key = 0; key < count_; ++key) {
        const auto& rules = reach_.rules[key];
        if (closes[key] || !std::any_of(rules.begin(), rules.end(), leads_there)) continue;
        closes[key] = changed = true;
      }
    }
  }

  void MarkReachable() {
    reachable_.assign(count_, false);
    std::vector<std::uint32_t> open;
    const auto reach = [&](const Contrapositive& rule) {
      for (const CompiledLiteral& literal : rule.body) {
        const std::uint32_t key = SignedOf(literal);
        if (reachable_[key]) continue;
        reachable_[key] = true;
        open.push_back(key);
      }
    };
    for (const Contrapositive* start : starts_) reach(*start);
    while (!open.empty()) {
      const std::uint32_t key = open.back();
      open.pop_back();
      for (const Contrapositive* rule : reach_.rules[key]) reach(*rule);
    }
  }

  /// Which goals can have their complement as an ancestor: not every goal that some other branch
  /// complements.
  void MarkMeeting() {
    meets_.assign(count_, false);
    for (std::uint32_t key = 0; key < count_; ++key) {
      if (predicates_[key / 2].kind == PredicateKind::kArithmetic) continue;
      meets_[key] = reachable_[key] && reachable_[Complement(key)] && Leads(Complement(key), key);
    }
  }

  /// Whether a goal of the one can have a goal of the other below it.
  bool Leads(std::uint32_t from, std::uint32_t to) const {
    std::vector<bool> seen(count_, false);
    std::vector<std::uint32_t> open = {from};
    while (!open.empty()) {
      const std::uint32_t key = open.back();
      open.pop_back();
      for (const Contrapositive* rule : reach_.rules[key]) {
        for (const CompiledLiteral& literal : rule->body) {
          const std::uint32_t next = SignedOf(literal);
          if (next == to) return true;
          if (seen[next]) continue;
          seen[next] = true;
          open.push_back(next);
        }
      }
    }
    return false;
  }

  bool IsBuiltIn(std::uint32_t key) const {
    const Predicates::Info& info = predicates_[key / 2];
    const bool positive = (key & 1U) != 0;
    if (info.kind != PredicateKind::kOrdinary) return true;
    return positive ? info.has_facts : info.minimized.has_value() && reach_.closing;
  }

  bool IsPossible(const CompiledLiteral& literal) const {
    const std::uint32_t key = SignedOf(literal);
    return provable_[key] || meets_[key];
  }

  bool IsPossible(const Contrapositive& rule) const {
    return std::all_of(rule.body.begin(), rule.body.end(),
                       [&](const CompiledLiteral& literal) { return IsPossible(literal); });
  }

  void MarkProvable() {
    provable_.assign(count_, false);
    for (std::uint32_t key = 0; key < count_; ++key) provable_[key] = IsBuiltIn(key);
    for (bool changed = true; changed;) {
      changed = false;
      for (std::uint32_t key = 0; key < count_; ++key) {
        const auto& rules = reach_.rules[key];
        if (provable_[key] ||
            !std::any_of(rules.begin(), rules.end(),
                         [&](const Contrapositive* rule) { return IsPossible(*rule); })) {
          continue;
        }
        provable_[key] = changed = true;
      }
    }
  }

  bool DropDeadRules() {
    bool dropped = false;
    for (std::uint32_t key = 0; key < count_; ++key) {
      dropped = std::erase_if(reach_.rules[key],
                              [&](const Contrapositive* rule) {
                                return !reachable_[key] || !IsPossible(*rule);
                              }) > 0 ||
                dropped;
    }
    return dropped;
  }

  void Summarize() {
    reach_.viable = std::any_of(starts_.begin(), starts_.end(),
                                [&](const Contrapositive* start) { return IsPossible(*start); });
    reach_.may_reduce = meets_;
    reach_.reduction_free =
        std::none_of(meets_.begin(), meets_.end(), [](bool meets) { return meets; });
    reach_.recursive = SortByHeight() < count_;
    for (std::uint32_t key = 0; key < count_; ++key) {
      if (!reachable_[key]) continue;
      const Predicates::Info& info = predicates_[key / 2];
      if ((key & 1U) != 0) reach_.sees.Add(key / 2);
      reach_.asks = reach_.asks || info.kind == PredicateKind::kAttachment ||
                    ((key & 1U) == 0 && info.minimized && reach_.closing);
    }
  }

  /// Kahn (1962): what cannot be sorted topologically lies on or behind a cycle. Says how many
  /// could be.
  std::size_t SortByHeight() {
    std::vector<std::size_t> incoming(count_, 0);
    const auto for_each_edge = [&](std::uint32_t key, auto&& visit) {
      for (const Contrapositive* rule : reach_.rules[key]) {
        for (const CompiledLiteral& literal : rule->body) visit(SignedOf(literal));
      }
    };
    for (std::uint32_t key = 0; key < count_; ++key) {
      for_each_edge(key, [&](std::uint32_t to) { ++incoming[to]; });
    }
    std::vector<std::uint32_t> open;
    for (std::uint32_t key = 0; key < count_; ++key) {
      if (incoming[key] == 0) open.push_back(key);
    }
    std::vector<std::uint32_t> height(count_, 1);
    std::size_t sorted = 0;
    while (!open.empty()) {
      const std::uint32_t key = open.back();
      open.pop_back();
      ++sorted;
      reach_.height = std::max(reach_.height, height[key]);
      for_each_edge(key, [&](std::uint32_t to) {
        height[to] = std::max(height[to], height[key] + 1);
        if (--incoming[to] == 0) open.push_back(to);
      });
    }
    return sorted;
  }

  const Predicates& predicates_;
  std::span<const Contrapositive* const> starts_;
  std::size_t count_;
  Reach reach_;
  std::vector<bool> reachable_;
  std::vector<bool> meets_;  ///< By signed predicate: the complement can be an ancestor.
  std::vector<bool> provable_;
};

}  // namespace

Reach FindReach(const Program& program, const Predicates& predicates,
                std::span<const Contrapositive* const> starts, bool closing) {
  return ReachFinder(program, predicates, starts, closing).Find();
}

}  // namespace latchwork::pttp

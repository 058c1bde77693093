// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/ordering.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace latchwork::pttp::saturation {
namespace {

/// The terms of a literal as the multiset that stands for it: a negative one counts twice.
struct Multiset {
  std::array<TermId, 4> terms{};
  std::size_t size = 0;

  explicit Multiset(const Literal& literal) {
    for (int copies = literal.positive ? 1 : 2; copies > 0; --copies) {
      terms[size++] = literal.left;
      terms[size++] = literal.right;
    }
  }
  const TermId* begin() const { return terms.data(); }
  const TermId* end() const { return terms.data() + size; }
};

void RemoveCommon(Multiset& a, Multiset& b) {
  for (std::size_t i = 0; i < a.size;) {
    auto* const twin = std::find(b.terms.data(), b.terms.data() + b.size, a.terms[i]);
    if (twin == b.end()) {
      ++i;
      continue;
    }
    *twin = b.terms[--b.size];
    a.terms[i] = a.terms[--a.size];
  }
}

}  // namespace

Order Reverse(Order order) {
  if (order == Order::kLess) return Order::kGreater;
  return order == Order::kGreater ? Order::kLess : order;
}

void Ordering::Clear() {
  for (const std::uint32_t variable : touched_) balance_[variable] = 0;
  touched_.clear();
  path_.clear();
  surplus_ = 0;
  lack_ = 0;
}

void Ordering::Count(TermId root, int sign) {
  visits_.assign(1, root);
  while (!visits_.empty()) {
    const TermId term = visits_.back();
    visits_.pop_back();
    if (Terms::IsVariable(term)) {
      const std::uint32_t variable = Terms::Number(term);
      if (variable >= balance_.size()) balance_.resize(variable + 1, 0);
      int& count = balance_[variable];
      touched_.push_back(variable);
      if (count > 0) --surplus_;
      if (count < 0) --lack_;
      count += sign;
      if (count > 0) ++surplus_;
      if (count < 0) ++lack_;
    } else if (!terms_.is_ground(term)) {
      for (const TermId argument : terms_.arguments(term)) visits_.push_back(argument);
    }
  }
}

bool Ordering::Covers(Order candidate) const {
  return candidate == Order::kGreater ? lack_ == 0 : surplus_ == 0;
}

// Goes down to where the terms part; path_ keeps the way. What is decided there holds if the
// variable condition does on every level.
Order Ordering::Candidate(TermId a, TermId b) {
  for (;;) {
    path_.push_back({a, b, 0});
    if (Terms::IsVariable(a)) return Terms::IsVariable(b) ? Order::kIncomparable : Order::kLess;
    if (Terms::IsVariable(b)) return Order::kGreater;
    if (terms_.weight(a) != terms_.weight(b)) {
      return terms_.weight(a) > terms_.weight(b) ? Order::kGreater : Order::kLess;
    }
    if (terms_.head(a) != terms_.head(b)) {
      return terms_.functor(terms_.head(a)).precedence > terms_.functor(terms_.head(b)).precedence
                 ? Order::kGreater
                 : Order::kLess;
    }
    const auto left = terms_.arguments(a);
    const auto right = terms_.arguments(b);
    std::uint32_t i = 0;
    while (left[i] == right[i]) ++i;
    path_.back().differs = i;
    a = left[i];
    b = right[i];
  }
}

Order Ordering::Compare(TermId a, TermId b) {
  if (a == b) return Order::kEqual;
  Clear();
  const Order candidate = Candidate(a, b);
  if (candidate == Order::kIncomparable) return candidate;
  if (terms_.is_ground(a) && terms_.is_ground(b)) return candidate;
  Count(path_.back().a, 1);
  Count(path_.back().b, -1);
  if (!Covers(candidate)) return Order::kIncomparable;
  for (std::size_t level = path_.size() - 1; level > 0; --level) {
    const Level& above = path_[level - 1];
    const auto left = terms_.arguments(above.a);
    const auto right = terms_.arguments(above.b);
    for (std::size_t i = above.differs + 1; i < left.size(); ++i) {
      if (left[i] == right[i]) continue;
      Count(left[i], 1);
      Count(right[i], -1);
    }
    if (!Covers(candidate)) return Order::kIncomparable;
  }
  return candidate;
}

Order Ordering::Compare(const Literal& a, const Literal& b) {
  Multiset left(a);
  Multiset right(b);
  RemoveCommon(left, right);
  if (left.size == 0 && right.size == 0) return Order::kEqual;
  const auto dominates = [&](const Multiset& big, const Multiset& small) {
    return big.size > 0 && std::all_of(small.begin(), small.end(), [&](TermId s) {
             return std::any_of(big.begin(), big.end(), [&](TermId g) { return Greater(g, s); });
           });
  };
  if (dominates(left, right)) return Order::kGreater;
  return dominates(right, left) ? Order::kLess : Order::kIncomparable;
}

}  // namespace latchwork::pttp::saturation

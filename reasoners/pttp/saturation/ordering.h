// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_ORDERING_H_
#define LATCHWORK_PTTP_SATURATION_ORDERING_H_

#include <cstdint>
#include <vector>

#include "reasoners/pttp/saturation/terms.h"

namespace latchwork::pttp::saturation {

/// An equation or its negation. An atom A is the equation `A = $true`.
struct Literal {
  TermId left = kNoTerm;
  TermId right = kTrue;
  bool positive = true;
  bool oriented = false;  ///< left is greater than right, under every substitution.
  bool eligible = false;  ///< Takes part in inferences.

  bool is_equation() const { return right != kTrue; }
  friend bool operator==(const Literal& a, const Literal& b) {
    return a.left == b.left && a.right == b.right && a.positive == b.positive;
  }
};

enum class Order : std::uint8_t { kLess, kEqual, kGreater, kIncomparable };

Order Reverse(Order order);

/// The Knuth-Bendix ordering on terms (weights and precedence from the functors, every variable
/// weighs 1) and its multiset extension to literals. Does not recurse.
class Ordering {
 public:
  explicit Ordering(const Terms& terms) : terms_(terms) {}

  Order Compare(TermId a, TermId b);
  bool Greater(TermId a, TermId b) { return Compare(a, b) == Order::kGreater; }
  Order Compare(const Literal& a, const Literal& b);

 private:
  struct Level {
    TermId a;
    TermId b;
    std::uint32_t differs;
  };

  Order Candidate(TermId a, TermId b);
  void Count(TermId root, int sign);
  bool Covers(Order candidate) const;
  void Clear();

  const Terms& terms_;
  std::vector<Level> path_;
  std::vector<int> balance_;  ///< By variable: occurrences left minus right.
  std::vector<std::uint32_t> touched_;
  std::vector<TermId> visits_;
  std::size_t surplus_ = 0;  ///< Variables that occur more often on the left,
  std::size_t lack_ = 0;     ///< and more often on the right.
};

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_ORDERING_H_

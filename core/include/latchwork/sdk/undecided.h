// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_UNDECIDED_H_
#define LATCHWORK_SDK_UNDECIDED_H_

#include <cstddef>
#include <span>
#include <vector>

#include "latchwork/logic/atom.h"

namespace latchwork::sdk {

/// Which of a list of undecided facts hold together: their indices, ascending. The others do not.
using GoalState = std::vector<std::size_t>;

/// Facts that may hold or not: a layer neither proved nor refuted them. `states`: each joint state
/// that they may be in, sorted; empty: any. Source: LSA, section 3.3 (disjunctions of goal
/// instances).
struct Undecided {
  std::vector<logic::Fact> facts;
  std::vector<GoalState> states;

  void Clear();
  /// Drops the facts whose indices are listed (ascending), in the states, too.
  void Drop(std::span<const std::size_t> indices);
  friend bool operator==(const Undecided&, const Undecided&) = default;
};

/// Sorts the states and leaves each of them once.
void Unite(std::vector<GoalState>& states);

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_UNDECIDED_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_STRATEGY_H_
#define LATCHWORK_PTTP_STRATEGY_H_

#include <cstdint>
#include <limits>

namespace latchwork::pttp {

/// What is not tried again once a goal has been solved (Otten, "Restricting backtracking in
/// connection calculi", 2010; Faerber, "A curiously effective backtracking strategy", 2021).
enum class Cut : std::uint8_t {
  kNone,       ///< Everything is tried again: complete.
  kExclusive,  ///< Other solutions of the subgoals of the step that solved it; other steps are.
  kInclusive,  ///< Neither other solutions of the subgoals nor other steps.
};

enum class Start : std::uint8_t { kConjecture, kNegative, kPositive };

enum class BodyOrder : std::uint8_t { kWritten, kFewest, kReversed };

/// How the tableau searches.
struct Strategy {
  Cut cut = Cut::kNone;
  Start start = Start::kNegative;
  BodyOrder order = BodyOrder::kWritten;
  bool lemmata = true;
  bool prune = true;  ///< What was solved without binding anything is not solved again.
  std::uint32_t deepest = std::numeric_limits<std::uint32_t>::max();
  std::uint64_t inferences = std::numeric_limits<std::uint64_t>::max();
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_STRATEGY_H_

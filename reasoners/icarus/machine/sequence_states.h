// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_SEQUENCE_STATES_H_
#define LATCHWORK_ICARUS_SEQUENCE_STATES_H_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

/// How far the sequences of a program have come, each for the values of its parameters.
class SequenceStates {
 public:
  struct State {
    std::uint32_t skill = 0;
    std::uint32_t step = 0;
    std::uint64_t hash = 0;     ///< Of the skill and the parameters.
    std::uint64_t touched = 0;  ///< Cycle in which it was last presented.
    bool changed = false;
    bool ended = false;              ///< It begins again in the next cycle that presents it.
    std::vector<Value> key;          ///< The parameters.
    std::vector<Value> environment;  ///< All variables; empty: as at the call.
    Arena arena{256};
    Arena other{256};
  };

  std::size_t size() const { return states_.size(); }
  State& at(std::size_t index) { return *states_[index]; }

  void Clear();
  SequenceStates Copy() const;
  /// Goes on with the states of another program's skills, and none of its own: `skills[i]` is the
  /// number here of its skill i, or kNoSkillHere when that is another skill now.
  void TakeOver(SequenceStates& other, std::span<const std::uint32_t> skills);
  static constexpr std::uint32_t kNoSkillHere = std::numeric_limits<std::uint32_t>::max();
  /// The state for these parameters, made when there is none.
  std::size_t Find(std::uint32_t skill, std::span<const Value> parameters, std::uint64_t cycle);
  /// Ends a cycle: drops, of the skills called in it, what was not presented, unless the cycle was
  /// cut short; and moves what is kept out of the memory of the cycle.
  void EndCycle(std::uint64_t cycle, bool is_whole);

 private:
  static void Keep(State& state);
  void Make(std::uint32_t skill, std::span<const Value> parameters, std::uint64_t hash);
  void Index();
  bool WasCalled(std::uint32_t skill, std::uint64_t cycle) const {
    return skill < called_.size() && called_[skill] == cycle;
  }

  std::vector<std::unique_ptr<State>> states_;
  std::vector<std::uint32_t> table_;   ///< States by hash: number + 1; 0: none.
  bool indexed_ = false;               ///< The table holds all states.
  std::vector<std::uint64_t> called_;  ///< The cycle in which each skill was called last.
  std::vector<std::unique_ptr<State>> free_;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_SEQUENCE_STATES_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_STATE_GRAPH_H_
#define LATCHWORK_PTTP_STATE_GRAPH_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/pttp/plans/ground_rules.h"
#include "reasoners/pttp/search/meter.h"
#include "reasoners/pttp/terms/row_set.h"

namespace latchwork::pttp {

inline constexpr std::uint32_t kNoState = 0xffffffffU;

/// The states that actions lead to from initial ones, nearest first: sets of atoms, each kept once
/// with a shortest way to it. An action is tried only when a rule that is no frame rule speaks of
/// it; after any other, what holds is part of what held before, and since rules need atoms and
/// never their absence, nothing is lost by leaving it out.
class StateGraph {
 public:
  explicit StateGraph(GroundRules& rules) : rules_(&rules) {}

  /// Starts anew from the rules as they are now.
  void Begin();
  std::uint32_t AddRoot(std::span<const std::uint32_t> atoms);
  /// Tries the actions of the next state. False when all states have been seen to, or the meter
  /// stopped.
  bool Grow(Meter& meter);

  std::size_t size() const { return states_.size(); }
  std::uint32_t LengthOf(std::uint32_t state) const { return states_[state].length; }
  std::uint32_t ParentOf(std::uint32_t state) const { return states_[state].parent; }
  std::uint32_t ActionOf(std::uint32_t state) const { return states_[state].action; }
  bool Holds(std::uint32_t state, std::uint32_t atom) const {
    return ((BitsOf(state)[atom / 64] >> (atom % 64)) & 1U) != 0;
  }
  bool HoldAll(std::uint32_t state, std::span<const std::uint32_t> atoms) const {
    return Hold(BitsOf(state), atoms);
  }
  /// Whether rules that speak of `spoken` speak of `action`.
  bool SpeaksOf(std::uint32_t spoken, std::uint32_t action) const {
    return spoken == action ||
           (!rules_->action(spoken).ground && rules_->IsInstance(action, spoken));
  }

 private:
  static constexpr std::size_t kMostWords = std::size_t{1} << 25U;
  struct State {
    std::uint32_t parent;
    std::uint32_t action;
    std::uint32_t length;
  };
  /// Lists of rules, one after the other.
  struct Lists {
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> rules;
    std::span<const std::uint32_t> of(std::uint32_t index) const {
      return {rules.data() + first[index], first[index + 1] - first[index]};
    }
  };

  const std::uint64_t* BitsOf(std::uint32_t state) const {
    return bits_.data() + std::size_t{state} * words_;
  }
  static bool Hold(const std::uint64_t* bits, std::span<const std::uint32_t> atoms) {
    return std::all_of(atoms.begin(), atoms.end(), [&](std::uint32_t atom) {
      return ((bits[atom / 64] >> (atom % 64)) & 1U) != 0;
    });
  }
  static void Set(std::uint64_t* bits, std::uint32_t atom) {
    bits[atom / 64] |= std::uint64_t{1} << (atom % 64);
  }

  template <typename Index>
  void Sort(Lists& lists, std::size_t count, std::span<const std::uint32_t> rules, Index&& index);
  void SortRules();
  void SortEffects(std::span<const std::uint32_t> effects);
  void MakeKept();
  void AddKept(std::uint32_t action, std::uint32_t spoken);
  void FindEffects(std::uint32_t state, Meter& meter);
  void Trigger(std::uint32_t rule);
  void Follow(std::uint32_t state, std::uint32_t action);
  void CloseWithin(std::uint64_t* bits);
  std::uint32_t Enter(const State& state);

  GroundRules* rules_;
  std::size_t words_ = 0;
  std::vector<std::uint64_t> bits_;
  std::vector<State> states_;
  RowSet known_;
  std::size_t next_ = 0;  ///< The state whose actions are tried next.

  std::vector<std::uint32_t> within_;
  std::vector<std::uint32_t> unconditional_;  ///< Effects that need no atom.
  Lists effects_;                             ///< By an atom that they need.
  Lists frames_;                              ///< Conditional ones, by the action as spoken of.
  Lists patterns_;                            ///< By action: what else speaks of it.
  std::vector<std::uint64_t> kept_;           ///< By action: what survives it.
  std::vector<std::uint32_t> needs_;          ///< By atom: how many effects need it.

  std::vector<std::uint64_t> successor_;
  std::vector<std::uint32_t> tried_;       ///< Actions with effects in the present state.
  std::vector<std::uint32_t> last_heads_;  ///< By action: index into heads_; kNoState: none.
  struct Head {
    std::uint32_t atom;
    std::uint32_t next;
  };
  std::vector<Head> heads_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_STATE_GRAPH_H_

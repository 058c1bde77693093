// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/sequence_states.h"

#include <algorithm>
#include <utility>

namespace latchwork::icarus {

std::size_t SequenceStates::Find(std::uint32_t skill, std::span<const Value> parameters,
                                 std::uint64_t cycle) {
  const auto found = std::find_if(states_.begin(), states_.end(), [&](const auto& state) {
    return state->skill == skill && std::equal(state->key.begin(), state->key.end(),
                                               parameters.begin(), parameters.end(), Equal);
  });
  const auto index = static_cast<std::size_t>(found - states_.begin());
  if (found == states_.end()) {
    if (free_.empty()) free_.push_back(std::make_unique<State>());
    states_.push_back(std::move(free_.back()));
    free_.pop_back();
    State& state = *states_.back();
    state.skill = skill;
    state.step = 0;
    state.ended = false;
    state.changed = true;
    state.key.assign(parameters.begin(), parameters.end());
    state.environment.clear();
  }
  State& state = *states_[index];
  if (state.ended && state.touched != cycle) {
    state.step = 0;
    state.environment.clear();
    state.changed = true;
    state.ended = false;
  }
  state.touched = cycle;
  return index;
}

void SequenceStates::Clear() {
  for (auto& state : states_) free_.push_back(std::move(state));
  states_.clear();
}

SequenceStates SequenceStates::Copy() const {
  SequenceStates copy;
  for (const auto& state : states_) {
    auto& made = *copy.states_.emplace_back(std::make_unique<State>());
    made.skill = state->skill;
    made.step = state->step;
    made.ended = state->ended;
    made.touched = state->touched;
    made.key = state->key;
    made.environment = state->environment;
    Keep(made);
  }
  return copy;
}

void SequenceStates::TakeOver(SequenceStates& other, std::span<const std::uint32_t> skills) {
  Clear();
  for (auto& state : other.states_) {
    const std::uint32_t skill = skills[state->skill];
    if (skill == kNoSkillHere) continue;
    state->skill = skill;
    states_.push_back(std::move(state));
  }
  other.states_.clear();
}

bool SequenceStates::WasCalled(std::uint32_t skill, std::uint64_t cycle) const {
  return std::any_of(states_.begin(), states_.end(), [&](const auto& state) {
    return state != nullptr && state->skill == skill && state->touched == cycle;
  });
}

void SequenceStates::EndCycle(std::uint64_t cycle, bool is_whole) {
  std::size_t kept = 0;
  for (auto& slot : states_) {
    State& state = *slot;
    if (is_whole && state.touched != cycle && WasCalled(state.skill, cycle)) {
      state.arena.Reset();
      free_.push_back(std::move(slot));
    } else if (state.changed) {
      Keep(state);
    }
  }
  for (auto& state : states_) {
    if (state != nullptr) std::swap(states_[kept++], state);
  }
  states_.resize(kept);
}

void SequenceStates::Keep(State& state) {
  state.other.Reset();
  for (Value& value : state.key) value = state.other.Copy(value);
  for (Value& value : state.environment) value = state.other.Copy(value);
  std::swap(state.arena, state.other);
  state.changed = false;
}

}  // namespace latchwork::icarus

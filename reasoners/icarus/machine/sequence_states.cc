// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/sequence_states.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace latchwork::icarus {

namespace {

std::uint64_t HashOf(std::uint32_t skill, std::span<const Value> parameters) {
  std::uint64_t hash = MixHash(0, skill);
  for (const Value& value : parameters) hash = MixHash(hash, Hash(value));
  return hash;
}

}  // namespace

std::size_t SequenceStates::Find(std::uint32_t skill, std::span<const Value> parameters,
                                 std::uint64_t cycle) {
  if (skill >= called_.size()) called_.resize(skill + 1);
  called_[skill] = cycle;
  const std::uint64_t hash = HashOf(skill, parameters);
  if (!indexed_ || 2 * states_.size() >= table_.size()) Index();
  const std::size_t mask = table_.size() - 1;
  std::size_t at = hash & mask;
  for (; table_[at] != 0; at = (at + 1) & mask) {
    const State& state = *states_[table_[at] - 1];
    if (state.hash == hash && state.skill == skill &&
        std::equal(state.key.begin(), state.key.end(), parameters.begin(), parameters.end(),
                   Equal)) {
      break;
    }
  }
  if (table_[at] == 0) {
    Make(skill, parameters, hash);
    table_[at] = static_cast<std::uint32_t>(states_.size());
  }
  State& state = *states_[table_[at] - 1];
  if (state.ended && state.touched != cycle) {
    state.step = 0;
    state.environment.clear();
    state.changed = true;
    state.ended = false;
  }
  state.touched = cycle;
  return table_[at] - 1;
}

void SequenceStates::Make(std::uint32_t skill, std::span<const Value> parameters,
                          std::uint64_t hash) {
  if (free_.empty()) free_.push_back(std::make_unique<State>());
  State& state = *states_.emplace_back(std::move(free_.back()));
  free_.pop_back();
  state.skill = skill;
  state.step = 0;
  state.hash = hash;
  state.ended = false;
  state.changed = true;
  state.key.assign(parameters.begin(), parameters.end());
  state.environment.clear();
}

void SequenceStates::Index() {
  table_.assign(std::bit_ceil(4 * states_.size() + 16), 0);
  const std::size_t mask = table_.size() - 1;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    std::size_t at = states_[i]->hash & mask;
    while (table_[at] != 0) at = (at + 1) & mask;
    table_[at] = static_cast<std::uint32_t>(i + 1);
  }
  indexed_ = true;
}

void SequenceStates::Clear() {
  for (auto& state : states_) free_.push_back(std::move(state));
  states_.clear();
  indexed_ = false;
}

SequenceStates SequenceStates::Copy() const {
  SequenceStates copy;
  for (const auto& state : states_) {
    auto& made = *copy.states_.emplace_back(std::make_unique<State>());
    made.skill = state->skill;
    made.step = state->step;
    made.hash = state->hash;
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
    state->hash = HashOf(skill, state->key);
    states_.push_back(std::move(state));
  }
  other.states_.clear();
  other.indexed_ = false;
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
  indexed_ = indexed_ && kept == states_.size();
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

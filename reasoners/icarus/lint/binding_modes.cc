// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/lint/binding_modes.h"

#include <utility>

namespace latchwork::icarus {

namespace {

/// Calls of skills that are followed at most; then nothing is known.
constexpr std::size_t kMostCalls = 1U << 19U;

bool Merge(const Exit& found, Exit& known) {
  bool changed = found.succeeds && !known.succeeds;
  known.succeeds = known.succeeds || found.succeeds;
  for (std::size_t i = 0; i < known.surely.size(); ++i) {
    const bool surely = known.surely[i] && found.surely[i];
    const bool may = known.may[i] || found.may[i];
    changed = changed || surely != known.surely[i] || may != known.may[i];
    known.surely[i] = surely;
    known.may[i] = may;
  }
  return changed;
}

}  // namespace

Exit BindingModes::Of(const Mode& mode) {
  if (!is_known_) return Unknown(mode.skill);
  const std::size_t wanted = Enter(mode);
  while (!waiting_.empty() && is_known_) {
    const std::size_t index = waiting_.front();
    waiting_.pop_front();
    Update(index);
  }
  return is_known_ ? entries_[wanted].exit : Unknown(mode.skill);
}

Exit BindingModes::Unknown(std::uint32_t skill) const {
  const std::size_t parameters = program_.skills[skill].parameters;
  return {true, Bits(parameters, true), Bits(parameters, true)};
}

std::size_t BindingModes::Enter(Mode mode) {
  const auto [place, is_new] = indices_.emplace(std::move(mode), modes_.size());
  if (is_new) {
    const std::size_t parameters = place->first.bound.size();
    waiting_.push_back(modes_.size());
    modes_.push_back(place->first);
    entries_.push_back({{false, Bits(parameters, true), Bits(parameters, false)}, {}, true});
  }
  return place->second;
}

void BindingModes::Update(std::size_t index) {
  entries_[index].waits = false;
  current_ = index;
  const Mode mode = modes_[index];
  const Exit exit = trace_.Follow(program_.skills[mode.skill], mode.bound);
  if (!Merge(exit, entries_[index].exit)) return;
  for (const std::size_t caller : entries_[index].callers) {
    if (std::exchange(entries_[caller].waits, true)) continue;
    waiting_.push_back(caller);
  }
}

Exit BindingModes::Call(Mode mode, const Clause&) {
  is_known_ = is_known_ && ++calls_ < kMostCalls;
  if (!is_known_) return Unknown(mode.skill);
  Entry& entry = entries_[Enter(std::move(mode))];
  if (entry.callers.empty() || entry.callers.back() != current_) entry.callers.push_back(current_);
  return entry.exit;
}

}  // namespace latchwork::icarus

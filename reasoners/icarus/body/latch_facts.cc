// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/body/latch_facts.h"

#include <algorithm>

namespace latchwork::icarus {

bool LatchFacts::Changed(std::size_t index) const {
  return held_[index] == nullptr || !Equal(held_[index]->value, values_[index]);
}

std::size_t LatchFacts::FirstChange() const {
  const std::size_t both = std::min(held_.size(), values_.size());
  std::size_t first = 0;
  while (first < both && !Changed(first)) ++first;
  return first;
}

bool LatchFacts::Set(std::span<const logic::Fact> facts, TermBridge& bridge, FactStore& memory) {
  arena_.Reset();
  values_.clear();
  for (const logic::Fact& fact : facts) values_.push_back(bridge.Import(fact, arena_));
  // Batches of the same length are compared fact by fact; else all from the first change on is new.
  const std::size_t first = FirstChange();
  const bool same_length = held_.size() == values_.size();
  const auto is_new = [&](std::size_t i) { return !same_length || Changed(i); };
  std::vector<const FactStore::Fact*>& held = held_;
  bool whole = true;
  const FactStore::Fact* before = first == 0 ? nullptr : held[first - 1];
  // A fact that was released marks its place until memory is tidied.
  for (std::size_t i = first; i < held.size(); ++i) {
    if (held[i] != nullptr && is_new(i)) memory.Release(held[i]);
  }
  const std::size_t known = held.size();
  held.resize(values_.size(), nullptr);
  for (std::size_t i = first; i < held.size(); ++i) {
    if (i < known && same_length && !Changed(i)) {
      before = held[i];
      continue;
    }
    const FactStore::Fact* const place = same_length && held[i] != nullptr ? held[i] : before;
    held[i] = values_[i].is_none() ? nullptr : memory.Hold(values_[i], place_ + i, place);
    whole = whole && held[i] != nullptr;
    if (held[i] != nullptr) before = held[i];
  }
  return whole;
}

}  // namespace latchwork::icarus

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_SENSOR_CACHE_H_
#define LATCHWORK_ICARUS_SENSOR_CACHE_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

/// The answers of host functions in one cycle, so that one cycle sees one world.
class SensorCache {
 public:
  SensorCache() : entries_(64) {}

  /// Forgets everything.
  void Clear() {
    ++generation_;
    used_ = 0;
  }

  /// Where the answer to a call is, or is to be kept.
  struct Slot {
    std::size_t at;
    std::uint64_t hash;
    const Value* answer;  ///< Null: none is kept.
  };

  Slot Find(std::uint32_t function, std::span<const Value> arguments) const {
    const std::uint64_t hash = Mix(function, arguments);
    const std::size_t at = Place(function, arguments, hash);
    const Entry& entry = entries_[at];
    return {at, hash, entry.generation == generation_ ? &entry.answer : nullptr};
  }

  /// Keeps an answer in the slot that Find gave last; `arguments` must stay until Clear.
  void Keep(const Slot& slot, std::uint32_t function, std::span<const Value> arguments,
            const Value& answer) {
    entries_[slot.at] = {generation_, slot.hash, function, arguments, answer};
    if (++used_ * 2 > entries_.size()) Grow();
  }

 private:
  struct Entry {
    std::uint64_t generation = 0;
    std::uint64_t hash = 0;
    std::uint32_t function = 0;
    std::span<const Value> arguments;
    Value answer;
  };

  static std::uint64_t Mix(std::uint32_t function, std::span<const Value> arguments) {
    std::uint64_t hash = function + 1;
    for (const Value& value : arguments) {
      hash = (hash ^ Hash(value)) * 0x9e3779b97f4a7c15ULL;
      hash ^= hash >> 31U;
    }
    return hash;
  }

  std::size_t Place(std::uint32_t function, std::span<const Value> arguments,
                    std::uint64_t hash) const {
    const std::size_t mask = entries_.size() - 1;
    std::size_t at = hash & mask;
    while (entries_[at].generation == generation_ &&
           !IsOf(entries_[at], function, arguments, hash)) {
      at = (at + 1) & mask;
    }
    return at;
  }

  static bool IsOf(const Entry& entry, std::uint32_t function, std::span<const Value> arguments,
                   std::uint64_t hash) {
    return entry.hash == hash && entry.function == function &&
           std::equal(entry.arguments.begin(), entry.arguments.end(), arguments.begin(),
                      arguments.end(), Equal);
  }

  void Grow() {
    std::vector<Entry> old(entries_.size() * 2);
    old.swap(entries_);
    for (const Entry& entry : old) {
      if (entry.generation != generation_) continue;
      entries_[Place(entry.function, entry.arguments, entry.hash)] = entry;
    }
  }

  std::vector<Entry> entries_;
  std::uint64_t generation_ = 1;
  std::size_t used_ = 0;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_SENSOR_CACHE_H_

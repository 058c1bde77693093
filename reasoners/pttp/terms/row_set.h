// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_ROW_SET_H_
#define LATCHWORK_PTTP_ROW_SET_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "reasoners/pttp/terms/word.h"

namespace latchwork::pttp {

/// A hash of a ground term that looks two levels deep; of an unbound variable, 0.
inline std::uint64_t ShallowHash(Word word) {
  const auto leaf = [](Word part) {
    if (IsNumber(part)) return MixHash(part & 7U, *AddressOf(part));
    if (TagOf(part) == Tag::kReference) return std::uint64_t{0};
    return MixHash(0, TagOf(part) == Tag::kCompound ? *AddressOf(part) : part);
  };
  std::uint64_t hash = leaf(word);
  if (TagOf(word) != Tag::kCompound) return hash;
  const Word* block = AddressOf(word);
  for (std::size_t i = ArityOf(block[0]); i > 0; --i) {
    hash = MixHash(hash, leaf(Dereference(block[i])));
  }
  return hash;
}

/// A hash set of numbers that stand for rows kept elsewhere. Keeps its memory when cleared.
class RowSet {
 public:
  void Clear() {
    if (entries_ * 8 < slots_.size()) {
      for (const std::size_t place : places_) slots_[place] = {};
    } else {
      std::fill(slots_.begin(), slots_.end(), Slot{});
    }
    places_.clear();
    entries_ = 0;
  }

  /// The number of a row that is the same, else `number`, which is entered.
  template <typename IsSame>
  std::uint32_t Enter(std::uint64_t hash, std::uint32_t number, IsSame&& is_same) {
    if ((entries_ + 1) * 2 > slots_.size()) Grow();
    const std::size_t mask = slots_.size() - 1;
    std::size_t place = hash & mask;
    for (; slots_[place].number != kEmpty; place = (place + 1) & mask) {
      if (slots_[place].hash == hash && is_same(slots_[place].number)) return slots_[place].number;
    }
    slots_[place] = {hash, number};
    places_.push_back(place);
    ++entries_;
    return number;
  }
  std::size_t size() const { return entries_; }

 private:
  static constexpr std::uint32_t kEmpty = 0xffffffffU;
  struct Slot {
    std::uint64_t hash = 0;
    std::uint32_t number = kEmpty;
  };

  void Grow() {
    std::vector<Slot> old(std::max<std::size_t>(64, slots_.size() * 2));
    old.swap(slots_);
    places_.clear();
    const std::size_t mask = slots_.size() - 1;
    for (const Slot& slot : old) {
      if (slot.number == kEmpty) continue;
      std::size_t place = slot.hash & mask;
      while (slots_[place].number != kEmpty) place = (place + 1) & mask;
      slots_[place] = slot;
      places_.push_back(place);
    }
  }

  std::vector<Slot> slots_;
  std::vector<std::size_t> places_;  ///< Of the slots in use.
  std::size_t entries_ = 0;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_ROW_SET_H_

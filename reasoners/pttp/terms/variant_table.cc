// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/terms/variant_table.h"

#include <algorithm>

namespace latchwork::pttp {

bool VariantTable::MakeKey(std::uint64_t label, std::span<const Word> terms, bool& ground) {
  key_.assign(1, label);
  variables_.clear();
  visits_.assign(terms.rbegin(), terms.rend());
  while (!visits_.empty()) {
    const Word word = Dereference(visits_.back());
    visits_.pop_back();
    switch (TagOf(word)) {
      case Tag::kReference: {
        const auto known = std::find(variables_.begin(), variables_.end(), word);
        key_.push_back(SlotWord(static_cast<std::uint32_t>(known - variables_.begin())));
        if (known == variables_.end()) variables_.push_back(word);
        break;
      }
      case Tag::kInteger:
      case Tag::kReal:
        key_.push_back(static_cast<Word>(TagOf(word)));
        key_.push_back(*AddressOf(word));
        break;
      case Tag::kCompound: {
        const Word* block = AddressOf(word);
        key_.push_back(block[0]);
        for (std::size_t i = ArityOf(block[0]); i > 0; --i) visits_.push_back(block[i]);
        break;
      }
      default:
        key_.push_back(word);
    }
    if (key_.size() > kLongestKey) return false;
  }
  ground = variables_.empty();
  return true;
}

std::uint32_t* VariantTable::Slot(std::uint64_t hash) {
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = hash & mask;; i = (i + 1) & mask) {
    std::uint32_t* slot = &slots_[i];
    if (*slot == kNoEntry) return slot;
    const Entry& entry = entries_[*slot];
    if (entry.hash == hash && entry.length == key_.size() &&
        std::equal(key_.begin(), key_.end(),
                   keys_.begin() + static_cast<std::ptrdiff_t>(entry.key))) {
      return slot;
    }
  }
}

void VariantTable::Grow() {
  slots_.assign(std::max<std::size_t>(64, slots_.size() * 2), kNoEntry);
  const std::size_t mask = slots_.size() - 1;
  for (std::uint32_t entry = 0; entry < entries_.size(); ++entry) {
    std::size_t i = entries_[entry].hash & mask;
    while (slots_[i] != kNoEntry) i = (i + 1) & mask;
    slots_[i] = entry;
  }
}

VariantTable::Found VariantTable::Enter(std::uint64_t label, std::span<const Word> terms) {
  Found found;
  if (!MakeKey(label, terms, found.ground)) return found;
  std::uint64_t hash = 0;
  for (const Word word : key_) hash = MixHash(hash, word);
  if ((entries_.size() + 1) * 2 > slots_.size()) Grow();
  std::uint32_t* slot = Slot(hash);
  if (*slot == kNoEntry) {
    *slot = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back({hash, keys_.size(), static_cast<std::uint32_t>(key_.size())});
    keys_.insert(keys_.end(), key_.begin(), key_.end());
    found.added = true;
  }
  found.entry = *slot;
  return found;
}

void VariantTable::Clear() {
  const std::size_t mask = slots_.size() - 1;
  if (entries_.size() * 8 < slots_.size()) {
    // Every entry's chain of slots is emptied; cheaper than sweeping a large table for a small
    // cycle.
    for (const Entry& entry : entries_) {
      for (std::size_t i = entry.hash & mask; slots_[i] != kNoEntry; i = (i + 1) & mask) {
        slots_[i] = kNoEntry;
      }
    }
  } else {
    std::fill(slots_.begin(), slots_.end(), kNoEntry);
  }
  entries_.clear();
  keys_.clear();
}

}  // namespace latchwork::pttp

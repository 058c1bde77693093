// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_VARIANT_TABLE_H_
#define LATCHWORK_PTTP_VARIANT_TABLE_H_

#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/pttp/terms/word.h"

namespace latchwork::pttp {

inline constexpr std::uint32_t kNoEntry = 0xffffffffU;

/// Numbers goals up to the names of their variables. Keeps its memory when cleared.
class VariantTable {
 public:
  /// A `label` (predicate, sign, …) and terms. `ground` tells whether there was a variable; a key
  /// longer than kLongestKey is not entered (kNoEntry).
  struct Found {
    std::uint32_t entry = kNoEntry;
    bool added = false;
    bool ground = false;
  };
  Found Enter(std::uint64_t label, std::span<const Word> terms);

  void Clear();
  std::size_t size() const { return entries_.size(); }
  /// Words held, for limits on memory.
  std::size_t words() const { return keys_.size() + 2 * entries_.size(); }

 private:
  static constexpr std::size_t kLongestKey = std::size_t{1} << 14U;
  struct Entry {
    std::uint64_t hash;
    std::uint64_t key;
    std::uint32_t length;
  };
  bool MakeKey(std::uint64_t label, std::span<const Word> terms, bool& ground);
  std::uint32_t* Slot(std::uint64_t hash);
  void Grow();

  std::vector<Entry> entries_;
  std::vector<Word> keys_;
  std::vector<std::uint32_t> slots_;
  std::vector<Word> key_;
  std::vector<Word> visits_;
  std::vector<Word> variables_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_VARIANT_TABLE_H_

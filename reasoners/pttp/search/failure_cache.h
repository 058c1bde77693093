// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_FAILURE_CACHE_H_
#define LATCHWORK_PTTP_FAILURE_CACHE_H_

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "reasoners/pttp/terms/variant_table.h"

namespace latchwork::pttp {

/// Which goals were found to have no proof within which depth, and, per level of iterative
/// deepening, which of them were searched without reaching the bound themselves. Only for goals
/// whose failure does not depend on their ancestors.
class FailureCache {
 public:
  VariantTable::Found Enter(std::uint64_t label, std::span<const Word> terms) {
    const VariantTable::Found found = goals_.Enter(label, terms);
    if (found.added) records_.push_back({});
    return found;
  }
  void Clear() {
    goals_.Clear();
    records_.clear();
  }
  std::size_t words() const { return goals_.words() + 4 * records_.size(); }

  /// A number for a new level; levels of nested searches interleave.
  std::uint64_t BeginLevel() { return ++last_level_; }

  bool FailsWithin(std::uint32_t entry, std::uint32_t depth) const {
    return records_[entry].failed_depth >= static_cast<std::int64_t>(depth);
  }
  /// `searched`: every rule for the goal was followed.
  void MarkFailed(std::uint32_t entry, std::uint32_t depth, bool searched, std::uint64_t level) {
    Record& record = records_[entry];
    record.failed_depth = std::max(record.failed_depth, static_cast<std::int64_t>(depth));
    if (searched) record.searched_level = level;
  }
  void MarkProved(std::uint32_t entry, std::uint64_t level) {
    records_[entry].proved_level = level;
  }

  /// After a level whose cut-off goals were all barren: what was barren in it has no proof at any
  /// depth.
  void Settle(std::uint64_t level) {
    for (std::uint32_t entry = 0; entry < records_.size(); ++entry) {
      if (IsBarren(entry, level)) records_[entry].failed_depth = kAnyDepth;
    }
  }
  bool FailsAlways(std::uint32_t entry) const { return records_[entry].failed_depth == kAnyDepth; }

  /// Remembers that the bound cut this goal off; true for the first time in a level.
  bool MarkCut(std::uint32_t entry, std::uint64_t level) {
    return std::exchange(records_[entry].cut_level, level) != level;
  }

  /// Whether the level searched this goal in full, in one place or another, and it never succeeded.
  /// When that holds for every goal that the bound cut off, no proof is beyond the bound: a
  /// smallest one would have to pass such a goal.
  bool IsBarren(std::uint32_t entry, std::uint64_t level) const {
    return records_[entry].searched_level == level && records_[entry].proved_level != level;
  }

 private:
  static constexpr std::int64_t kAnyDepth = std::numeric_limits<std::int64_t>::max();
  struct Record {
    std::int64_t failed_depth = -1;
    std::uint64_t searched_level = 0;
    std::uint64_t proved_level = 0;
    std::uint64_t cut_level = 0;
  };
  VariantTable goals_;
  std::vector<Record> records_;
  std::uint64_t last_level_ = 0;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_FAILURE_CACHE_H_

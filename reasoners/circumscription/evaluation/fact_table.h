// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EVALUATION_FACT_TABLE_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EVALUATION_FACT_TABLE_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/circumscription/values/value.h"

namespace latchwork::circumscription {

/// A fact of some table, or an assumption.
struct FactRef {
  static constexpr std::uint32_t kAssumption = UINT32_MAX;
  std::uint32_t relation = 0;  ///< kAssumption: `row` is the number of an assumption.
  std::uint32_t row = 0;
  friend bool operator==(const FactRef&, const FactRef&) = default;
};

/// How a fact came about.
struct FactInfo {
  enum class Origin : std::uint8_t { kBody, kLatch, kRule, kAttachment };
  Origin origin = Origin::kBody;
  int rank = 0;              ///< The latest level of a default that it rests on; 0: on none.
  std::uint32_t source = 0;  ///< Number of the latch or the rule.
  std::uint32_t height = 0;  ///< Of its derivation.
  std::size_t first_premise = 0;
  std::size_t premises = 0;
};

/// The facts of one predicate, each once, in the order in which they came. Keeps its memory when it
/// is cleared.
class FactTable {
 public:
  static constexpr std::uint32_t kNone = RowTable::kNone;

  FactTable(std::size_t arity, std::span<const std::size_t> columns);

  std::uint32_t size() const { return static_cast<std::uint32_t>(infos_.size()); }
  std::span<const Value> Row(std::uint32_t row) const {
    return {cells_.data() + row * arity_, arity_};
  }
  FactInfo& info(std::uint32_t row) { return infos_[row]; }
  const FactInfo& info(std::uint32_t row) const { return infos_[row]; }

  std::uint32_t Find(std::span<const Value> cells) const;
  /// The number of the row, which was there already unless it is the last one.
  std::uint32_t Insert(std::span<const Value> cells, const FactInfo& info);
  bool IsIndexed(std::size_t column) const;
  /// The rows with `value` in an indexed column, in order, from First by Next to kNone.
  std::uint32_t First(std::size_t column, const Value& value) const;
  std::uint32_t Next(std::size_t column, std::uint32_t row) const;
  void AddIndex(std::size_t column);
  void Clear();

 private:
  struct Index {
    std::size_t column = 0;
    RowTable firsts;
    std::vector<std::uint32_t> next;
    std::vector<std::uint32_t> last;  ///< By first row.
  };
  void Enter(Index& index, std::uint32_t row);
  const Index& Of(std::size_t column) const;

  std::size_t arity_;
  std::vector<Value> cells_;
  std::vector<FactInfo> infos_;
  RowTable rows_;
  std::vector<Index> indexes_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EVALUATION_FACT_TABLE_H_

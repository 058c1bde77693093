// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_CLAUSES_H_
#define LATCHWORK_PTTP_SATURATION_CLAUSES_H_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "reasoners/pttp/saturation/ordering.h"
#include "reasoners/pttp/saturation/terms.h"

namespace latchwork::pttp::saturation {

using ClauseId = std::uint32_t;
inline constexpr ClauseId kNoClause = std::numeric_limits<ClauseId>::max();

enum class Rule : std::uint8_t {
  kInput,
  kResolution,
  kSuperposition,
  kFactoring,
  kEqualityFactoring,
  kEqualityResolution,
  kSimplification,
};
std::string_view Name(Rule rule);

/// A clause in the making.
struct Draft {
  std::vector<Literal> literals;
  std::vector<ClauseId> parents;
  Rule rule = Rule::kInput;
  bool changed = false;

  /// A parent is named once.
  void AddParent(ClauseId parent);
};

enum class State : std::uint8_t { kPassive, kActive, kDead };

struct ClauseRecord {
  std::uint32_t first_literal = 0;
  std::uint32_t literal_count = 0;
  std::uint32_t first_parent = 0;
  std::uint32_t parent_count = 0;
  std::uint32_t size = 0;
  std::uint32_t goal_weight = 0;
  Rule rule = Rule::kInput;
  State state = State::kPassive;
  bool goal = false;  ///< Descends from the negated conjecture.
};

/// Every clause that was kept, with where it came from. Ids rise with time.
class Clauses {
 public:
  explicit Clauses(const Terms& terms) : terms_(terms) {}

  ClauseId Add(const Draft& draft, bool goal);
  std::size_t size() const { return records_.size(); }
  ClauseRecord& record(ClauseId id) { return records_[id]; }
  const ClauseRecord& record(ClauseId id) const { return records_[id]; }
  std::span<Literal> literals(ClauseId id) {
    return {literals_.data() + records_[id].first_literal, records_[id].literal_count};
  }
  std::span<const Literal> literals(ClauseId id) const {
    return {literals_.data() + records_[id].first_literal, records_[id].literal_count};
  }
  std::span<const ClauseId> parents(ClauseId id) const {
    return {parents_.data() + records_[id].first_parent, records_[id].parent_count};
  }
  std::size_t bytes() const;

 private:
  const Terms& terms_;
  std::vector<ClauseRecord> records_;
  std::vector<Literal> literals_;
  std::vector<ClauseId> parents_;
};

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_CLAUSES_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_CLAUSE_INDEX_H_
#define LATCHWORK_PTTP_CLAUSE_INDEX_H_

#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "latchwork/logic/clause.h"

namespace latchwork::pttp {

/// A literal of a clause.
struct LiteralPlace {
  std::uint32_t clause = 0;
  std::uint32_t literal = 0;
};

/// Predicate, number of arguments and sign.
struct LiteralKey {
  logic::PredicateName name;
  bool positive = true;
  friend auto operator<=>(const LiteralKey&, const LiteralKey&) = default;
};

inline LiteralKey KeyOf(const logic::Literal& literal) {
  return {NameOf(literal.atom), literal.positive};
}
inline logic::Literal ComplementOf(const logic::Literal& literal) {
  return {!literal.positive, literal.atom};
}

/// Where literals of each key stand. The clauses must outlive it.
class ClauseIndex {
 public:
  explicit ClauseIndex(std::span<const logic::Clause> clauses) : clauses_(clauses) {
    for (std::uint32_t i = 0; i < clauses.size(); ++i) {
      const auto& literals = clauses[i].literals;
      for (std::uint32_t j = 0; j < literals.size(); ++j) {
        places_[KeyOf(literals[j])].push_back({i, j});
      }
    }
  }

  std::span<const logic::Clause> clauses() const { return clauses_; }
  const logic::Literal& literal(const LiteralPlace& place) const {
    return clauses_[place.clause].literals[place.literal];
  }
  /// What could conclude a goal with this key.
  std::span<const LiteralPlace> Find(const LiteralKey& key) const {
    const auto place = places_.find(key);
    return place == places_.end() ? std::span<const LiteralPlace>() : place->second;
  }
  const std::map<LiteralKey, std::vector<LiteralPlace>>& places() const { return places_; }

 private:
  std::span<const logic::Clause> clauses_;
  std::map<LiteralKey, std::vector<LiteralPlace>> places_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_CLAUSE_INDEX_H_

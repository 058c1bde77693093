// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_SUBSUMPTION_H_
#define LATCHWORK_PTTP_SATURATION_SUBSUMPTION_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/pttp/saturation/clauses.h"
#include "reasoners/pttp/saturation/fixed_trie.h"
#include "reasoners/pttp/saturation/substitution.h"
#include "reasoners/pttp/saturation/terms.h"

namespace latchwork::pttp::saturation {

/// Multiset subsumption: an instance of one clause is part of another.
class Subsumer {
 public:
  explicit Subsumer(Terms& terms) : terms_(terms), matcher_(terms) {}

  /// Never says true wrongly; may say false when the search for the instance gets long.
  bool Subsumes(std::span<const Literal> general, std::span<const Literal> special);

 private:
  bool Cover(std::size_t next, std::span<const Literal> special);
  bool CoverBy(std::size_t next, const Literal& target, std::span<const Literal> special);
  bool Assign(const Literal& pattern, TermId left, TermId right, std::size_t next,
              std::span<const Literal> special);

  Terms& terms_;
  Matcher matcher_;
  std::vector<Literal> pattern_;
  std::vector<std::uint8_t> used_;
  std::size_t steps_ = 0;
};

/// Clauses by numbers that never fall when literals are added or variables instantiated (Schulz,
/// Simple and Efficient Clause Subsumption with Feature Vector Indexing, 2013).
class FeatureIndex {
 public:
  explicit FeatureIndex(const Terms& terms) : terms_(terms) {}

  void Insert(ClauseId id, std::span<const Literal> literals) {
    trie_.Insert(Features(literals), id);
  }
  void Erase(ClauseId id, std::span<const Literal> literals) {
    trie_.Erase(Features(literals), [id](ClauseId entry) { return entry == id; });
  }
  /// Calls `visit(clause)` for what may subsume the literals until it returns true.
  template <class Visit>
  bool SearchSubsumers(std::span<const Literal> literals, const Visit& visit) {
    const auto key = Features(literals);
    return trie_.Search([&](std::size_t i, std::int32_t part) { return part <= key[i]; }, visit);
  }
  /// The same for what the literals may subsume.
  template <class Visit>
  bool SearchSubsumed(std::span<const Literal> literals, const Visit& visit) {
    const auto key = Features(literals);
    return trie_.Search([&](std::size_t i, std::int32_t part) { return part >= key[i]; }, visit);
  }
  std::size_t bytes() const { return trie_.bytes(); }

 private:
  static constexpr std::size_t kClasses = 7;
  static constexpr std::size_t kFeatures = 2 + 2 * kClasses;
  using Trie = FixedTrie<ClauseId, kFeatures>;

  Trie::Key Features(std::span<const Literal> literals);

  const Terms& terms_;
  Trie trie_;
  std::vector<TermId> visits_;
};

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_SUBSUMPTION_H_

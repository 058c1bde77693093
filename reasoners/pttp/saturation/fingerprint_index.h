// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_FINGERPRINT_INDEX_H_
#define LATCHWORK_PTTP_SATURATION_FINGERPRINT_INDEX_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/pttp/saturation/clauses.h"
#include "reasoners/pttp/saturation/fixed_trie.h"
#include "reasoners/pttp/saturation/terms.h"

namespace latchwork::pttp::saturation {

/// Where an indexed term stands.
struct Occurrence {
  TermId term = kNoTerm;
  ClauseId clause = kNoClause;
  std::uint32_t literal = 0;
  bool left = true;  ///< On the left side of the literal.
};

/// Which indexed terms are candidates for a query.
enum class Fit : std::uint8_t { kUnifiable, kGeneralization, kInstance };

/// Terms by what stands at eight fixed positions of theirs (Schulz, Fingerprint Indexing for
/// Paramodulation and Rewriting, IJCAR 2012). Finds candidates: unify or match them to be sure.
class FingerprintIndex {
 public:
  explicit FingerprintIndex(const Terms& terms) : terms_(terms) {}

  void Insert(const Occurrence& occurrence);
  /// Removes what `clause` entered under any of these terms.
  void Erase(std::span<const TermId> terms, ClauseId clause);

  /// Calls `visit(occurrence)` for the candidates until it returns true; says whether it did.
  template <class Visit>
  bool Search(Fit fit, TermId query, const Visit& visit) const {
    const Trie::Key key = Fingerprint(query);
    return trie_.Search(
        [&](std::size_t level, std::int32_t part) { return Fits(fit, key[level], part); }, visit);
  }
  std::size_t bytes() const { return trie_.bytes(); }

 private:
  static constexpr std::size_t kPositions = 8;
  using Trie = FixedTrie<Occurrence, kPositions>;

  Trie::Key Fingerprint(TermId term) const;
  std::int32_t Argument(TermId term, std::int32_t part, std::size_t index, TermId& argument) const;
  static bool Fits(Fit fit, std::int32_t query, std::int32_t indexed);

  const Terms& terms_;
  Trie trie_;
  std::vector<Trie::Key> keys_;
};

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_FINGERPRINT_INDEX_H_

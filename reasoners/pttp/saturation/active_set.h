// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_ACTIVE_SET_H_
#define LATCHWORK_PTTP_SATURATION_ACTIVE_SET_H_

#include <cstddef>
#include <span>
#include <vector>

#include "reasoners/pttp/saturation/clauses.h"
#include "reasoners/pttp/saturation/fingerprint_index.h"
#include "reasoners/pttp/saturation/subsumption.h"
#include "reasoners/pttp/saturation/terms.h"

namespace latchwork::pttp::saturation {

/// The clauses among which all inferences were made, in every index that finds partners for
/// another.
class ActiveSet {
 public:
  ActiveSet(const Terms& terms, Clauses& clauses);

  void Insert(ClauseId id) { Change(id, true); }
  void Erase(ClauseId id) { Change(id, false); }

  /// Unit equations, by the sides that may be rewritten.
  const FingerprintIndex& demodulators() const { return demodulators_; }
  /// All other units, by both sides.
  const FingerprintIndex& units() const { return units_; }
  /// Every subterm that is no variable, of every literal.
  const FingerprintIndex& subterms() const { return subterms_; }
  /// Sides of eligible positive literals that may replace.
  const FingerprintIndex& from() const { return from_; }
  /// Subterms of eligible literals that may be replaced.
  const FingerprintIndex& into() const { return into_; }
  FeatureIndex& features() { return features_; }
  std::size_t bytes() const;

 private:
  void Change(ClauseId id, bool insert);
  void ChangeUnit(const Literal& literal, ClauseId id, bool insert);
  void ChangeSubterms(ClauseId id, bool insert);
  void ChangePartners(std::uint32_t number, const Literal& literal, ClauseId id, bool insert);
  /// Enters the occurrence with each of these terms, or takes them all out.
  static void ChangeAll(FingerprintIndex& index, std::span<const TermId> terms,
                        Occurrence occurrence, bool insert);

  const Terms& terms_;
  Clauses& clauses_;
  FingerprintIndex demodulators_;
  FingerprintIndex units_;
  FingerprintIndex subterms_;
  FingerprintIndex from_;
  FingerprintIndex into_;
  FeatureIndex features_;
  std::vector<TermId> found_;
};

/// Appends the subterms of `root`, itself included, that are no variables and sorts them, each
/// once.
void CollectSubterms(const Terms& terms, TermId root, std::vector<TermId>& found);

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_ACTIVE_SET_H_

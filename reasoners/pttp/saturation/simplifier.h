// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_SIMPLIFIER_H_
#define LATCHWORK_PTTP_SATURATION_SIMPLIFIER_H_

#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/pttp/saturation/active_set.h"
#include "reasoners/pttp/saturation/clauses.h"
#include "reasoners/pttp/saturation/ordering.h"
#include "reasoners/pttp/saturation/rebuilder.h"
#include "reasoners/pttp/saturation/substitution.h"
#include "reasoners/pttp/saturation/subsumption.h"

namespace latchwork::pttp::saturation {

enum class Effort : std::uint8_t {
  kCheap,  ///< For every conclusion: rewriting and units.
  kFull,   ///< For the given clause: subsumption by all clauses, too.
};

/// Makes clauses simpler or finds that they say nothing new, by what is in the active set. Every
/// clause used is added to the parents.
class Simplifier {
 public:
  Simplifier(Terms& terms, Ordering& ordering, const Clauses& clauses, ActiveSet& active);

  /// What needs no other clause: literals that are false, doubled or complementary, variables that
  /// only name a term, orientation of equations. False: the clause is a tautology.
  bool Clean(Draft& draft);
  /// False: the clause is redundant.
  bool Forward(Draft& draft, Effort effort);
  /// The active clauses that `id`, not yet active itself, subsumes; and those that it may rewrite
  /// or shorten. Both sorted.
  void Backward(ClauseId id, std::vector<ClauseId>& subsumed, std::vector<ClauseId>& touched);
  /// To be called when a unit equation became active.
  void NoteDemodulator() { ++stamp_; }

 private:
  enum class Truth : std::uint8_t { kOpen, kHolds, kFails };

  /// How far the root of a term may be rewritten.
  enum class Root : std::uint8_t {
    kFree,
    kGuarded,  ///< Not by a variant: the larger side of a positive equation (completeness).
    kFixed,    ///< Not at all: an atom.
  };

  Truth Evaluate(const Literal& literal) const;
  /// False: a literal is true.
  bool RemoveFalse(Draft& draft);
  void Orient(Literal& literal);
  /// Drops a literal `X != t` and puts t for X.
  bool ResolveVariable(Draft& draft);
  bool Occurs(TermId variable, TermId in);
  /// False: two literals are complementary.
  bool Merge(Draft& draft);

  bool Rewrite(Draft& draft);
  TermId Normalize(TermId term, Root root, Draft& draft);
  TermId NormalizeFree(TermId term, Draft& draft);
  TermId NormalizeArguments(TermId term, Draft& draft);
  TermId RewriteOnce(TermId term, bool guarded, Draft& draft);
  /// What `rule` makes of the term, or kNoTerm.
  TermId Replacement(const Occurrence& rule, TermId term, bool guarded);

  /// False: an active unit implies the clause.
  bool CutByUnits(Draft& draft);
  /// An active unit of the given sign that generalizes the literal, or kNoClause.
  ClauseId FindUnit(const Literal& literal, bool positive);
  bool MatchesPair(const Occurrence& unit, TermId first, TermId second);
  /// A unit equation that gives `left = right`, be it inside equal contexts.
  ClauseId FindEquation(TermId left, TermId right);
  bool IsSubsumed(std::span<const Literal> literals, ClauseId* by);
  void CutBySubsumption(Draft& draft);
  void TouchInstances(ClauseId id, const Literal& literal, bool left,
                      std::vector<ClauseId>& touched);

  Terms& terms_;
  Ordering& ordering_;
  const Clauses& clauses_;
  ActiveSet& active_;
  Subsumer subsumer_;
  Matcher matcher_;
  Rebuilder rebuilder_;
  std::vector<TermId> visits_;
  std::vector<TermId> arguments_;
  std::uint32_t stamp_ = 1;
  std::size_t rewrites_ = 0;  ///< Of the draft at hand.
};

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_SIMPLIFIER_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_INFERENCES_H_
#define LATCHWORK_PTTP_SATURATION_INFERENCES_H_

#include <cstdint>
#include <vector>

#include "reasoners/pttp/saturation/active_set.h"
#include "reasoners/pttp/saturation/clauses.h"
#include "reasoners/pttp/saturation/ordering.h"
#include "reasoners/pttp/saturation/substitution.h"

namespace latchwork::pttp::saturation {

/// What to do with conclusions.
class ConclusionSink {
 public:
  ConclusionSink() = default;
  ConclusionSink(const ConclusionSink&) = delete;
  ConclusionSink& operator=(const ConclusionSink&) = delete;
  virtual ~ConclusionSink() = default;

  /// Whether the clause was kept; if not, its new terms are forgotten.
  virtual bool Accept(Draft& draft) = 0;
  /// Ends the generation.
  virtual bool Stopped() const = 0;
};

/// The generating rules of the superposition calculus (Bachmair and Ganzinger 1994), atoms being
/// equations with $true: superposition and resolution are one rule that replaces all occurrences
/// of a term at once, and so are factoring and equality factoring.
class Inferences {
 public:
  Inferences(Terms& terms, Ordering& ordering, const Clauses& clauses, const ActiveSet& active);

  /// All conclusions of an active clause with itself and the other active ones.
  void Generate(ClauseId given, ConclusionSink& sink);
  /// A conclusion was lost because of its size.
  bool overflowed() const { return substitution_.overflowed(); }

 private:
  /// One side of a literal, and in `into` the term inside it that is to be replaced.
  struct Site {
    ClauseId clause;
    std::uint32_t literal;
    bool left;
    TermId term;
  };

  void ResolveEquality(ClauseId given, ConclusionSink& sink);
  void Factor(ClauseId given, ConclusionSink& sink);
  void FactorPair(ClauseId given, std::uint32_t i, std::uint32_t j, ConclusionSink& sink);
  void FactorSides(ClauseId given, std::uint32_t i, bool i_left, std::uint32_t j, bool j_left,
                   ConclusionSink& sink);
  void SuperposeFrom(ClauseId given, ConclusionSink& sink);
  void SuperposeInto(ClauseId given, ConclusionSink& sink);
  void SuperposeIntoSide(const Site& side, ConclusionSink& sink);
  void Superpose(const Site& from, const Site& into, ConclusionSink& sink);
  Literal Instance(const Literal& literal, std::uint32_t bank);
  bool StaysMaximal(const Site& site, std::uint32_t bank, bool strictly);
  /// Whether the ordering still asks for the inference after unification.
  bool IsAllowed(const Site& from, const Site& into);
  /// The instance of this side is not the larger one.
  bool IsSmaller(const Literal& literal, bool left, std::uint32_t bank);
  void AddRest(ClauseId clause, std::uint32_t without, std::uint32_t bank);
  void AddInstance(const Literal& literal, std::uint32_t bank, Item from, TermId to);
  void Emit(std::size_t mark, ConclusionSink& sink);

  Terms& terms_;
  Ordering& ordering_;
  const Clauses& clauses_;
  const ActiveSet& active_;
  Substitution substitution_;
  Draft draft_;
  bool fits_ = true;
  std::vector<Occurrence> partners_;
  std::vector<TermId> subterms_;
};

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_INFERENCES_H_

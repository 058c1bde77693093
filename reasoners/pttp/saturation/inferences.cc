// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/inferences.h"

namespace latchwork::pttp::saturation {
namespace {

TermId Side(const Literal& literal, bool left) { return left ? literal.left : literal.right; }

/// Both sides of an equation that has no larger one, else the left side.
bool Usable(const Literal& literal, bool left) {
  return left || (literal.is_equation() && !literal.oriented);
}

}  // namespace

Inferences::Inferences(Terms& terms, Ordering& ordering, const Clauses& clauses,
                       const ActiveSet& active)
    : terms_(terms),
      ordering_(ordering),
      clauses_(clauses),
      active_(active),
      substitution_(terms) {}

void Inferences::Generate(ClauseId given, ConclusionSink& sink) {
  ResolveEquality(given, sink);
  Factor(given, sink);
  SuperposeFrom(given, sink);
  SuperposeInto(given, sink);
}

void Inferences::AddInstance(const Literal& literal, std::uint32_t bank, Item from, TermId to) {
  Literal instance;
  instance.positive = literal.positive;
  instance.left = substitution_.ApplyReplacing({literal.left, bank}, from, to);
  instance.right = literal.right == kTrue
                       ? kTrue
                       : substitution_.ApplyReplacing({literal.right, bank}, from, to);
  fits_ = fits_ && instance.left != kNoTerm && instance.right != kNoTerm;
  draft_.literals.push_back(instance);
}

void Inferences::AddRest(ClauseId clause, std::uint32_t without, std::uint32_t bank) {
  const auto literals = clauses_.literals(clause);
  for (std::uint32_t i = 0; i < literals.size(); ++i) {
    if (i != without) AddInstance(literals[i], bank, {}, kNoTerm);
  }
}

void Inferences::Emit(std::size_t mark, ConclusionSink& sink) {
  const bool kept = fits_ && sink.Accept(draft_);
  if (!kept) terms_.Rollback(mark);
  draft_ = {};
  fits_ = true;
}

bool Inferences::IsSmaller(const Literal& literal, bool left, std::uint32_t bank) {
  if (literal.oriented) return !left;
  const TermId side = substitution_.Apply({Side(literal, left), bank});
  const TermId other = substitution_.Apply({Side(literal, !left), bank});
  if (side == kNoTerm || other == kNoTerm) return true;
  const Order order = ordering_.Compare(side, other);
  return order == Order::kLess || order == Order::kEqual;
}

void Inferences::ResolveEquality(ClauseId given, ConclusionSink& sink) {
  for (std::uint32_t i = 0; i < clauses_.literals(given).size() && !sink.Stopped(); ++i) {
    const Literal literal = clauses_.literals(given)[i];
    if (!literal.eligible || literal.positive || !literal.is_equation()) continue;
    substitution_.Reset();
    if (!substitution_.Unify({literal.left, 0}, {literal.right, 0})) continue;
    const std::size_t mark = terms_.Mark();
    draft_.rule = Rule::kEqualityResolution;
    draft_.parents = {given};
    AddRest(given, i, 0);
    Emit(mark, sink);
  }
}

void Inferences::Factor(ClauseId given, ConclusionSink& sink) {
  const auto count = clauses_.record(given).literal_count;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Literal first = clauses_.literals(given)[i];
    if (!first.eligible || !first.positive) continue;
    for (std::uint32_t j = 0; j < count && !sink.Stopped(); ++j) {
      const Literal second = clauses_.literals(given)[j];
      if (j == i || !second.positive || first.is_equation() != second.is_equation()) continue;
      if (j < i && second.eligible && !first.is_equation()) continue;
      FactorPair(given, i, j, sink);
    }
  }
}

void Inferences::FactorPair(ClauseId given, std::uint32_t i, std::uint32_t j,
                            ConclusionSink& sink) {
  for (const bool i_left : {true, false}) {
    for (const bool j_left : {true, false}) {
      const bool sides = Usable(clauses_.literals(given)[i], i_left) &&
                         (j_left || clauses_.literals(given)[j].is_equation());
      if (sides && !sink.Stopped()) FactorSides(given, i, i_left, j, j_left, sink);
    }
  }
}

void Inferences::FactorSides(ClauseId given, std::uint32_t i, bool i_left, std::uint32_t j,
                             bool j_left, ConclusionSink& sink) {
  const Literal first = clauses_.literals(given)[i];
  const Literal second = clauses_.literals(given)[j];
  substitution_.Reset();
  if (!substitution_.Unify({Side(first, i_left), 0}, {Side(second, j_left), 0})) return;
  const std::size_t mark = terms_.Mark();
  if (first.is_equation() && IsSmaller(first, i_left, 0)) {
    terms_.Rollback(mark);
    return;
  }
  draft_.rule = first.is_equation() ? Rule::kEqualityFactoring : Rule::kFactoring;
  draft_.parents = {given};
  AddRest(given, j, 0);
  if (first.is_equation()) {
    Literal apart;
    apart.left = Side(first, !i_left);
    apart.right = Side(second, !j_left);
    apart.positive = false;
    AddInstance(apart, 0, {}, kNoTerm);
  }
  Emit(mark, sink);
}

void Inferences::SuperposeFrom(ClauseId given, ConclusionSink& sink) {
  for (std::uint32_t i = 0; i < clauses_.record(given).literal_count; ++i) {
    const Literal literal = clauses_.literals(given)[i];
    if (!literal.eligible || !literal.positive) continue;
    for (const bool left : {true, false}) {
      if (!Usable(literal, left)) continue;
      const Site from{given, i, left, Side(literal, left)};
      active_.into().Search(Fit::kUnifiable, from.term, [&](const Occurrence& into) {
        Superpose(from, {into.clause, into.literal, into.left, into.term}, sink);
        return sink.Stopped();
      });
    }
  }
}

void Inferences::SuperposeInto(ClauseId given, ConclusionSink& sink) {
  for (std::uint32_t i = 0; i < clauses_.record(given).literal_count; ++i) {
    const Literal literal = clauses_.literals(given)[i];
    if (!literal.eligible) continue;
    for (const bool left : {true, false}) {
      if (Usable(literal, left)) {
        SuperposeIntoSide({given, i, left, Side(literal, left)}, sink);
      }
    }
  }
}

void Inferences::SuperposeIntoSide(const Site& side, ConclusionSink& sink) {
  const Literal literal = clauses_.literals(side.clause)[side.literal];
  subterms_.clear();
  CollectSubterms(terms_, side.term, subterms_);
  for (const TermId term : subterms_) {
    if (term == side.term && literal.positive && !literal.is_equation()) continue;
    const Site into{side.clause, side.literal, side.left, term};
    active_.from().Search(Fit::kUnifiable, term, [&](const Occurrence& from) {
      // The pair of a clause with itself is met in SuperposeFrom.
      if (from.clause != side.clause) {
        Superpose({from.clause, from.literal, from.left, from.term}, into, sink);
      }
      return sink.Stopped();
    });
  }
}

Literal Inferences::Instance(const Literal& literal, std::uint32_t bank) {
  Literal instance;
  instance.positive = literal.positive;
  instance.left = substitution_.Apply({literal.left, bank});
  instance.right = literal.is_equation() ? substitution_.Apply({literal.right, bank}) : kTrue;
  return instance;
}

// A positive literal took part because it was maximal; whether the substitution left it so.
bool Inferences::StaysMaximal(const Site& site, std::uint32_t bank, bool strictly) {
  const auto literals = clauses_.literals(site.clause);
  if (literals.size() == 1 || !literals[site.literal].positive) return true;
  const Literal instance = Instance(literals[site.literal], bank);
  for (std::uint32_t i = 0; i < literals.size(); ++i) {
    if (i == site.literal) continue;
    const Literal other = Instance(literals[i], bank);
    if (other.left == kNoTerm || other.right == kNoTerm) return false;
    const Order order = ordering_.Compare(other, instance);
    if (order == Order::kGreater || (strictly && order == Order::kEqual)) return false;
  }
  return true;
}

bool Inferences::IsAllowed(const Site& from, const Site& into) {
  const Literal& source = clauses_.literals(from.clause)[from.literal];
  const Literal& target = clauses_.literals(into.clause)[into.literal];
  return !(source.is_equation() && IsSmaller(source, from.left, 0)) &&
         !(target.is_equation() && IsSmaller(target, into.left, 1)) &&
         StaysMaximal(from, 0, true) && StaysMaximal(into, 1, false);
}

void Inferences::Superpose(const Site& from, const Site& into, ConclusionSink& sink) {
  const Literal source = clauses_.literals(from.clause)[from.literal];
  const Literal target = clauses_.literals(into.clause)[into.literal];
  const bool whole_atom = !target.is_equation() && into.term == target.left;
  if (source.is_equation() == whole_atom) return;
  substitution_.Reset();
  if (!substitution_.Unify({from.term, 0}, {into.term, 1})) return;
  const std::size_t mark = terms_.Mark();
  const TermId to =
      source.is_equation() ? substitution_.Apply({Side(source, !from.left), 0}) : kTrue;
  if (to == kNoTerm || !IsAllowed(from, into)) {
    terms_.Rollback(mark);
    return;
  }
  draft_.rule = whole_atom ? Rule::kResolution : Rule::kSuperposition;
  draft_.parents = {from.clause};
  draft_.AddParent(into.clause);
  for (const Literal& literal : clauses_.literals(into.clause)) {
    AddInstance(literal, 1, {into.term, 1}, to);
  }
  AddRest(from.clause, from.literal, 0);
  Emit(mark, sink);
}

}  // namespace latchwork::pttp::saturation

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/simplifier.h"

#include <algorithm>

namespace latchwork::pttp::saturation {

Simplifier::Simplifier(Terms& terms, Ordering& ordering, const Clauses& clauses, ActiveSet& active)
    : terms_(terms),
      ordering_(ordering),
      clauses_(clauses),
      active_(active),
      subsumer_(terms),
      matcher_(terms),
      rebuilder_(terms) {}

Simplifier::Truth Simplifier::Evaluate(const Literal& literal) const {
  const auto truth = [&](bool equal) {
    return equal == literal.positive ? Truth::kHolds : Truth::kFails;
  };
  if (literal.left == literal.right) return truth(true);
  if (Terms::IsVariable(literal.left) || Terms::IsVariable(literal.right)) return Truth::kOpen;
  using Distinct = Functor::Distinct;
  const Distinct left = terms_.functor(terms_.head(literal.left)).distinct;
  const Distinct right = terms_.functor(terms_.head(literal.right)).distinct;
  if (left == Distinct::kNo || right == Distinct::kNo) return Truth::kOpen;
  const bool comparable = left == right || left == Distinct::kObject || right == Distinct::kObject;
  return comparable ? truth(false) : Truth::kOpen;
}

bool Simplifier::RemoveFalse(Draft& draft) {
  for (std::size_t i = 0; i < draft.literals.size();) {
    const Truth truth = Evaluate(draft.literals[i]);
    if (truth == Truth::kHolds) return false;
    if (truth == Truth::kFails) {
      draft.literals.erase(draft.literals.begin() + static_cast<std::ptrdiff_t>(i));
      draft.changed = true;
    } else {
      ++i;
    }
  }
  return true;
}

bool Simplifier::Occurs(TermId variable, TermId in) {
  visits_.assign(1, in);
  while (!visits_.empty()) {
    const TermId term = visits_.back();
    visits_.pop_back();
    if (term == variable) return true;
    if (Terms::IsVariable(term) || terms_.is_ground(term)) continue;
    for (const TermId argument : terms_.arguments(term)) visits_.push_back(argument);
  }
  return false;
}

bool Simplifier::ResolveVariable(Draft& draft) {
  const auto is_name = [&](const Literal& l) {
    return !l.positive && ((Terms::IsVariable(l.left) && !Occurs(l.left, l.right)) ||
                           (Terms::IsVariable(l.right) && !Occurs(l.right, l.left)));
  };
  const auto found = std::ranges::find_if(draft.literals, is_name);
  if (found == draft.literals.end()) return false;
  const bool left = Terms::IsVariable(found->left) && !Occurs(found->left, found->right);
  const TermId variable = left ? found->left : found->right;
  matcher_.Bind(Terms::Number(variable), left ? found->right : found->left);
  std::vector<Literal> literals = draft.literals;
  literals.erase(literals.begin() + (found - draft.literals.begin()));
  bool fits = true;
  for (Literal& literal : literals) {
    literal.left = matcher_.Apply(literal.left);
    literal.right = matcher_.Apply(literal.right);
    fits = fits && literal.left != kNoTerm && literal.right != kNoTerm;
  }
  matcher_.Undo(0);
  if (!fits) return false;
  draft.literals = std::move(literals);
  draft.changed = true;
  return true;
}

void Simplifier::Orient(Literal& literal) {
  if (!literal.is_equation() && literal.left != kTrue) {
    literal.oriented = true;
    return;
  }
  const Order order = ordering_.Compare(literal.left, literal.right);
  if (order == Order::kLess) std::swap(literal.left, literal.right);
  literal.oriented = order == Order::kLess || order == Order::kGreater;
}

bool Simplifier::Merge(Draft& draft) {
  std::vector<Literal>& literals = draft.literals;
  for (std::size_t i = 0; i < literals.size(); ++i) {
    for (std::size_t j = i + 1; j < literals.size();) {
      const Literal& a = literals[i];
      const Literal& b = literals[j];
      const bool same =
          (a.left == b.left && a.right == b.right) || (a.left == b.right && a.right == b.left);
      if (same && a.positive != b.positive) return false;
      if (!same) {
        ++j;
        continue;
      }
      literals.erase(literals.begin() + static_cast<std::ptrdiff_t>(j));
      draft.changed = true;
    }
  }
  return true;
}

bool Simplifier::Clean(Draft& draft) {
  do {
    if (!RemoveFalse(draft)) return false;
  } while (ResolveVariable(draft));
  for (Literal& literal : draft.literals) Orient(literal);
  return Merge(draft);
}

bool Simplifier::Forward(Draft& draft, Effort effort) {
  if (!Clean(draft)) return false;
  if (Rewrite(draft) && !Clean(draft)) return false;
  if (!CutByUnits(draft)) return false;
  if (effort == Effort::kCheap) return true;
  if (IsSubsumed(draft.literals, nullptr)) return false;
  CutBySubsumption(draft);
  return true;
}

bool Simplifier::CutByUnits(Draft& draft) {
  for (std::size_t i = 0; i < draft.literals.size();) {
    const Literal& literal = draft.literals[i];
    if (FindUnit(literal, literal.positive) != kNoClause) return false;
    const ClauseId opposite = FindUnit(literal, !literal.positive);
    if (opposite == kNoClause) {
      ++i;
      continue;
    }
    draft.AddParent(opposite);
    draft.literals.erase(draft.literals.begin() + static_cast<std::ptrdiff_t>(i));
    draft.changed = true;
  }
  return true;
}

bool Simplifier::MatchesPair(const Occurrence& unit, TermId first, TermId second) {
  const Literal& literal = clauses_.literals(unit.clause)[0];
  const TermId other = unit.left ? literal.right : literal.left;
  const bool matches = matcher_.Match(unit.term, first) && matcher_.Match(other, second);
  matcher_.Undo(0);
  return matches;
}

ClauseId Simplifier::FindUnit(const Literal& literal, bool positive) {
  if (positive && literal.is_equation()) return FindEquation(literal.left, literal.right);
  ClauseId found = kNoClause;
  const auto search = [&](TermId first, TermId second) {
    return active_.units().Search(Fit::kGeneralization, first, [&](const Occurrence& unit) {
      if (clauses_.literals(unit.clause)[0].positive != positive) return false;
      if (!MatchesPair(unit, first, second)) return false;
      found = unit.clause;
      return true;
    });
  };
  if (search(literal.left, literal.right)) return found;
  if (literal.is_equation()) search(literal.right, literal.left);
  return found;
}

ClauseId Simplifier::FindEquation(TermId left, TermId right) {
  for (;;) {
    ClauseId found = kNoClause;
    const auto search = [&](TermId first, TermId second) {
      active_.demodulators().Search(Fit::kGeneralization, first, [&](const Occurrence& unit) {
        if (!MatchesPair(unit, first, second)) return false;
        found = unit.clause;
        return true;
      });
      return found != kNoClause;
    };
    if (search(left, right) || search(right, left)) return found;
    if (Terms::IsVariable(left) || Terms::IsVariable(right)) return kNoClause;
    if (terms_.head(left) != terms_.head(right)) return kNoClause;
    const auto a = terms_.arguments(left);
    const auto b = terms_.arguments(right);
    const auto [at_a, at_b] = std::ranges::mismatch(a, b);
    if (!std::equal(at_a + 1, a.end(), at_b + 1)) return kNoClause;
    left = *at_a;
    right = *at_b;
  }
}

bool Simplifier::IsSubsumed(std::span<const Literal> literals, ClauseId* by) {
  return active_.features().SearchSubsumers(literals, [&](ClauseId candidate) {
    if (!subsumer_.Subsumes(clauses_.literals(candidate), literals)) return false;
    if (by != nullptr) *by = candidate;
    return true;
  });
}

void Simplifier::CutBySubsumption(Draft& draft) {
  for (std::size_t i = 0; i < draft.literals.size() && draft.literals.size() > 1;) {
    draft.literals[i].positive = !draft.literals[i].positive;
    ClauseId by = kNoClause;
    const bool cut = IsSubsumed(draft.literals, &by);
    draft.literals[i].positive = !draft.literals[i].positive;
    if (!cut) {
      ++i;
      continue;
    }
    draft.AddParent(by);
    draft.literals.erase(draft.literals.begin() + static_cast<std::ptrdiff_t>(i));
    draft.changed = true;
    i = 0;
  }
}

void Simplifier::Backward(ClauseId id, std::vector<ClauseId>& subsumed,
                          std::vector<ClauseId>& touched) {
  const auto literals = clauses_.literals(id);
  active_.features().SearchSubsumed(literals, [&](ClauseId candidate) {
    if (subsumer_.Subsumes(literals, clauses_.literals(candidate))) subsumed.push_back(candidate);
    return false;
  });
  std::ranges::sort(subsumed);
  if (literals.size() != 1) return;
  const Literal& literal = literals[0];
  TouchInstances(id, literal, true, touched);
  if (literal.is_equation() && !literal.oriented) TouchInstances(id, literal, false, touched);
  std::ranges::sort(touched);
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  std::erase_if(touched, [&](ClauseId t) { return std::ranges::binary_search(subsumed, t); });
}

void Simplifier::TouchInstances(ClauseId id, const Literal& literal, bool left,
                                std::vector<ClauseId>& touched) {
  if (literal.is_equation() && !literal.positive) return;
  const TermId side = left ? literal.left : literal.right;
  active_.subterms().Search(Fit::kInstance, side, [&](const Occurrence& occurrence) {
    const bool matches = literal.is_equation()
                             ? Replacement({side, id, 0, left}, occurrence.term, false) != kNoTerm
                             : matcher_.Match(side, occurrence.term);
    matcher_.Undo(0);
    if (matches) touched.push_back(occurrence.clause);
    return false;
  });
}

}  // namespace latchwork::pttp::saturation

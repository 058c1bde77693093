// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/active_set.h"

#include <algorithm>

namespace latchwork::pttp::saturation {

void CollectSubterms(const Terms& terms, TermId root, std::vector<TermId>& found) {
  std::size_t next = found.size();
  if (!Terms::IsVariable(root)) found.push_back(root);
  for (; next < found.size(); ++next) {
    for (const TermId argument : terms.arguments(found[next])) {
      if (!Terms::IsVariable(argument)) found.push_back(argument);
    }
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

ActiveSet::ActiveSet(const Terms& terms, Clauses& clauses)
    : terms_(terms),
      clauses_(clauses),
      demodulators_(terms),
      units_(terms),
      subterms_(terms),
      from_(terms),
      into_(terms),
      features_(terms) {}

void ActiveSet::ChangeAll(FingerprintIndex& index, std::span<const TermId> terms,
                          Occurrence occurrence, bool insert) {
  if (!insert) {
    index.Erase(terms, occurrence.clause);
    return;
  }
  for (const TermId term : terms) {
    occurrence.term = term;
    index.Insert(occurrence);
  }
}

void ActiveSet::Change(ClauseId id, bool insert) {
  const auto literals = clauses_.literals(id);
  if (insert) {
    features_.Insert(id, literals);
  } else {
    features_.Erase(id, literals);
  }
  if (literals.size() == 1) ChangeUnit(literals[0], id, insert);
  ChangeSubterms(id, insert);
  for (std::uint32_t i = 0; i < literals.size(); ++i) {
    if (literals[i].eligible) ChangePartners(i, literals[i], id, insert);
  }
}

void ActiveSet::ChangeUnit(const Literal& literal, ClauseId id, bool insert) {
  const bool rewrites = literal.positive && literal.is_equation();
  FingerprintIndex& index = rewrites ? demodulators_ : units_;
  ChangeAll(index, {&literal.left, 1}, {kNoTerm, id, 0, true}, insert);
  if (literal.is_equation() && !literal.oriented) {
    ChangeAll(index, {&literal.right, 1}, {kNoTerm, id, 0, false}, insert);
  }
}

void ActiveSet::ChangeSubterms(ClauseId id, bool insert) {
  found_.clear();
  for (const Literal& literal : clauses_.literals(id)) {
    CollectSubterms(terms_, literal.left, found_);
    if (literal.is_equation()) CollectSubterms(terms_, literal.right, found_);
  }
  ChangeAll(subterms_, found_, {kNoTerm, id, 0, true}, insert);
}

void ActiveSet::ChangePartners(std::uint32_t number, const Literal& literal, ClauseId id,
                               bool insert) {
  const bool both_sides = literal.is_equation() && !literal.oriented;
  for (const bool left : {true, false}) {
    if (!left && !both_sides) continue;
    const TermId side = left ? literal.left : literal.right;
    if (literal.positive) ChangeAll(from_, {&side, 1}, {kNoTerm, id, number, left}, insert);
    found_.clear();
    CollectSubterms(terms_, side, found_);
    const bool positive_atom = literal.positive && !literal.is_equation();
    if (positive_atom) std::erase(found_, side);
    ChangeAll(into_, found_, {kNoTerm, id, number, left}, insert);
  }
}

std::size_t ActiveSet::bytes() const {
  return demodulators_.bytes() + units_.bytes() + subterms_.bytes() + from_.bytes() +
         into_.bytes() + features_.bytes();
}

}  // namespace latchwork::pttp::saturation

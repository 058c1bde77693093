// SPDX-License-Identifier: BSD-3-Clause
// Demodulation: the part of the simplifier that rewrites terms by unit equations.
#include <vector>

#include "reasoners/pttp/saturation/simplifier.h"

namespace latchwork::pttp::saturation {
namespace {

constexpr std::size_t kMaxRewrites = 20'000;

}  // namespace

TermId Simplifier::Replacement(const Occurrence& rule, TermId term, bool guarded) {
  const Literal& literal = clauses_.literals(rule.clause)[0];
  TermId result = kNoTerm;
  if (matcher_.Match(rule.term, term) && !(guarded && matcher_.IsRenaming())) {
    result = matcher_.Apply(rule.left ? literal.right : literal.left);
  }
  matcher_.Undo(0);
  if (result == kNoTerm || literal.oriented) return result;
  return ordering_.Greater(term, result) ? result : kNoTerm;
}

TermId Simplifier::RewriteOnce(TermId term, bool guarded, Draft& draft) {
  TermId result = term;
  if (rewrites_ >= kMaxRewrites || terms_.stamp(term) == stamp_) return term;
  active_.demodulators().Search(Fit::kGeneralization, term, [&](const Occurrence& rule) {
    const TermId next = Replacement(rule, term, guarded);
    if (next == kNoTerm) return false;
    result = next;
    draft.AddParent(rule.clause);
    ++rewrites_;
    return true;
  });
  if (result == term && !guarded) terms_.SetStamp(term, stamp_);
  return result;
}

TermId Simplifier::NormalizeFree(TermId term, Draft& draft) {
  const auto enter = [&](const Item& item) {
    const bool done = Terms::IsVariable(item.term) || terms_.stamp(item.term) == stamp_;
    return done ? item.term : kNoTerm;
  };
  const TermId result = rebuilder_.Build(
      {term, 0}, enter, [&](TermId built) { return RewriteOnce(built, false, draft); });
  return result == kNoTerm ? term : result;
}

TermId Simplifier::NormalizeArguments(TermId term, Draft& draft) {
  if (Terms::IsVariable(term)) return term;
  const auto arguments = terms_.arguments(term);
  arguments_.assign(arguments.begin(), arguments.end());
  for (TermId& argument : arguments_) argument = NormalizeFree(argument, draft);
  return terms_.Make(terms_.head(term), arguments_);
}

TermId Simplifier::Normalize(TermId term, Root root, Draft& draft) {
  if (root == Root::kFree) return NormalizeFree(term, draft);
  for (;;) {
    term = NormalizeArguments(term, draft);
    if (root == Root::kFixed || Terms::IsVariable(term)) return term;
    const TermId next = RewriteOnce(term, true, draft);
    if (next == term) return term;
    term = next;
  }
}

bool Simplifier::Rewrite(Draft& draft) {
  rewrites_ = 0;
  for (Literal& literal : draft.literals) {
    if (!literal.is_equation()) {
      literal.left = Normalize(literal.left, Root::kFixed, draft);
      continue;
    }
    const Root larger = literal.positive ? Root::kGuarded : Root::kFree;
    literal.left = Normalize(literal.left, larger, draft);
    literal.right = Normalize(literal.right, literal.oriented ? Root::kFree : larger, draft);
  }
  draft.changed = draft.changed || rewrites_ > 0;
  return rewrites_ > 0;
}

}  // namespace latchwork::pttp::saturation

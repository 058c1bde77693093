// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/plans/ground_rules.h"

#include <algorithm>

namespace latchwork::pttp {

void GroundRules::Clear() {
  terms_.Clear();
  atom_numbers_.Clear();
  action_numbers_.Clear();
  atoms_.clear();
  actions_.clear();
  for (auto& atoms : by_predicate_) atoms.clear();
  rules_.clear();
  bodies_.clear();
  assumptions_.clear();
  known_.Clear();
}

const Word* GroundRules::Copy(std::span<const Word> terms) {
  Word* copy = terms_.Allocate(terms.size());
  for (std::size_t i = 0; i < terms.size(); ++i) copy[i] = Copy(terms[i]);
  return copy;
}

GroundRules::Entered GroundRules::EnterAtom(PredicateId predicate,
                                            std::span<const Word> arguments) {
  const VariantTable::Found found = atom_numbers_.Enter(predicate, arguments);
  if (found.added) {
    atoms_.push_back({predicate, Copy(arguments)});
    if (predicate >= by_predicate_.size()) by_predicate_.resize(predicate + 1);
    by_predicate_[predicate].push_back(found.entry);
  }
  return {found.entry, found.added, found.ground && found.entry != kNoEntry};
}

GroundRules::Entered GroundRules::EnterAction(Word header, std::span<const Word> arguments) {
  const VariantTable::Found found = action_numbers_.Enter(header, arguments);
  if (found.added) actions_.push_back({header, Copy(arguments), found.ground});
  return {found.entry, found.added, found.ground && found.entry != kNoEntry};
}

bool GroundRules::IsInstance(std::uint32_t action, std::uint32_t of) {
  const Action& special = actions_[action];
  const Action& general = actions_[of];
  if (special.header != general.header) return false;
  matcher_.ForgetTrail();
  bool same = true;
  for (std::size_t i = 0; same && i + 1 < ArityOf(special.header); ++i) {
    same = matcher_.Unify(general.arguments[i], special.arguments[i]);
  }
  matcher_.UndoTo(0);
  return same;
}

void GroundRules::AddRule(GroundRule rule, std::span<const std::uint32_t> body,
                          std::span<const std::size_t> assumptions) {
  std::uint64_t hash = MixHash(static_cast<std::uint64_t>(rule.kind), rule.head);
  hash = MixHash(hash, rule.action);
  for (const std::uint32_t atom : body) hash = MixHash(hash, atom);
  const auto fresh = static_cast<std::uint32_t>(rules_.size());
  const std::uint32_t number = known_.Enter(hash, fresh, [&](std::uint32_t other) {
    const GroundRule& known = rules_[other];
    const auto known_body = BodyOf(known);
    return known.kind == rule.kind && known.head == rule.head && known.action == rule.action &&
           std::equal(body.begin(), body.end(), known_body.begin(), known_body.end());
  });
  if (number != fresh) return;
  rule.body = static_cast<std::uint32_t>(bodies_.size());
  rule.size = static_cast<std::uint32_t>(body.size());
  bodies_.insert(bodies_.end(), body.begin(), body.end());
  rule.assumptions = static_cast<std::uint32_t>(assumptions_.size());
  rule.assumed = static_cast<std::uint32_t>(assumptions.size());
  assumptions_.insert(assumptions_.end(), assumptions.begin(), assumptions.end());
  rules_.push_back(rule);
}

}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
// The part of the machine that looks fluents up in situations.
#include <algorithm>

#include "reasoners/pttp/search/machine.h"

namespace latchwork::pttp {

/// A fluent in a situation that is not known yet, or in a known one. Any other situation is left to
/// the rules; where steps are recorded, any that is known.
bool Machine::TrySituations(Choice& choice) {
  const Node& node = *choice.node;
  if (situations_ == nullptr || !node.literal->positive) return false;
  const SituationRules& rules = situations_->rules();
  if (!rules.IsFluent(node.literal->predicate)) return false;
  if (choice.question == kNoEntry) {
    const std::uint32_t position = rules.PositionOf(node.literal->predicate);
    const Word situation = Dereference(node.arguments[position]);
    choice.table = kNoState;
    const bool known = TagOf(situation) != Tag::kReference;
    if (record_ && (known || selected_.activation != choice.continuation.activation)) return false;
    if (known) {
      choice.table = situations_->StateOf(situation);
      if (choice.table == kNoState) return false;
    }
    Word* others = shop_.heap->Allocate(node.literal->arity - 1);
    for (std::uint32_t i = 0, next = 0; i < node.literal->arity; ++i) {
      if (i != position) others[next++] = node.arguments[i];
    }
    choice.question = situations_->Ask(node.literal->predicate, {others, node.literal->arity - 1});
    if (choice.question == kNoEntry) return false;
  }
  Situations::Instance instance;
  while (FindInstance(choice, instance)) {
    shop_.meter->CountWork();
    if (Instantiate(choice, instance)) return true;
    Retreat(choice);
  }
  if (choice.cut) NoteCut(choice.entry);
  choice.phase = Phase::kClosing;
  return false;
}

bool Machine::FindInstance(Choice& choice, Situations::Instance& instance) {
  if (shop_.meter->stopped()) return false;
  if (choice.table != kNoState) {
    return situations_->FindIn(choice.table, choice.question, choice.rule, instance);
  }
  const auto answer = situations_->Find(choice.question, choice.rule, choice.node->remaining,
                                        *shop_.meter, instance);
  ++choice.rule;
  choice.cut = answer == Situations::Answer::kTooFar;
  return answer == Situations::Answer::kFound;
}

bool Machine::Instantiate(Choice& choice, const Situations::Instance& instance) {
  const Node& node = *choice.node;
  const std::uint32_t position = situations_->rules().PositionOf(node.literal->predicate);
  const Word* known = situations_->ArgumentsOf(instance.atom);
  for (std::uint32_t i = 0; i < node.literal->arity; ++i) {
    if (i == position) continue;
    if (!unifier_.Unify(node.arguments[i], *known++)) return false;
  }
  if (!unifier_.Unify(node.arguments[position], situations_->SituationOf(instance.state))) {
    return false;
  }
  if (record_) {
    choice.proved = true;
    continuation_ = choice.continuation;
    const Activation* activation = choice.continuation.activation;
    delayed_ = shop_.heap->Make(Delayed{node.literal, activation, choice.delayed});
    return true;
  }
  for (const std::size_t assumption : situations_->AssumptionsOf(instance)) RestOn(assumption);
  const std::uint32_t length = situations_->LengthOf(instance.state) + 1;
  depth_ = std::max(depth_, level_depth_ - node.remaining + length);
  const bool bound_before = TagOf(node.literal->arguments[position]) != Tag::kSlot;
  if (!bound_before && situations_->rules().IsChoice(node.literal)) {
    ++chosen_;
    ++all_chosen_;
  }
  return SolvedAtOnce(choice, {.kind = Step::Kind::kFact, .node = &node});
}

}  // namespace latchwork::pttp

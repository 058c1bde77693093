// SPDX-License-Identifier: BSD-3-Clause
// The part of the machine that chooses the next subgoal.
#include <bit>

#include "reasoners/pttp/search/machine.h"

namespace latchwork::pttp {
namespace {

constexpr std::uint32_t kWindow = 64;

std::uint64_t LowBits(std::size_t count) {
  return count >= kWindow ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

}  // namespace

bool Machine::HasRules(const CompiledLiteral& literal) const {
  return !reach_->RulesFor(Signed(literal.predicate, literal.positive)).empty();
}

std::uint64_t Machine::Needs(const CompiledLiteral& literal) const {
  if (literal.positive) return literal.needs_ground;
  const Predicates::Info& info = (*shop_.predicates)[literal.predicate];
  const bool closed = info.minimized.has_value() && reach_->closing;
  const bool compared = info.kind == PredicateKind::kEquality && !HasRules(literal) &&
                        !reach_->MayReduce(Signed(literal.predicate, false));
  return closed || compared ? LowBits(literal.arity) : literal.needs_ground;
}

bool Machine::IsReady(const CompiledLiteral& literal, const Activation& activation) const {
  for (std::uint64_t needs = Needs(literal); needs != 0; needs &= needs - 1) {
    const auto argument = static_cast<std::size_t>(std::countr_zero(needs));
    if (!unifier_.IsGround(literal.arguments[argument], activation.slots)) return false;
  }
  return true;
}

int Machine::FindEager(const Activation& activation) const {
  if (continuation_.base != 0) return -1;
  for (std::uint64_t bits = continuation_.mask & activation.rule->eager; bits != 0;
       bits &= bits - 1) {
    const int bit = std::countr_zero(bits);
    const CompiledLiteral& literal = activation.rule->body[static_cast<std::size_t>(bit)];
    if (!HasRules(literal) && IsReady(literal, activation)) return bit;
  }
  return -1;
}

int Machine::FindExtensional(const Activation& activation) const {
  for (std::uint64_t bits = continuation_.mask; bits != 0; bits &= bits - 1) {
    const int bit = std::countr_zero(bits);
    const CompiledLiteral& literal =
        activation.rule->body[continuation_.base + static_cast<std::size_t>(bit)];
    if (!literal.positive || literal.needs_ground != 0 || HasRules(literal) ||
        (*shop_.predicates)[literal.predicate].kind != PredicateKind::kOrdinary) {
      continue;
    }
    for (std::uint32_t i = 0; i < literal.arity; ++i) {
      const Word argument = literal.arguments[i];
      const Word bound = TagOf(argument) == Tag::kSlot
                             ? Dereference(activation.slots[NumberOf(argument)])
                             : argument;
      if (TagOf(bound) != Tag::kReference) return bit;
    }
  }
  return -1;
}

bool Machine::SelectFrom(const Activation& activation) {
  int bit = FindEager(activation);
  if (bit < 0) {
    bit = std::countr_zero(continuation_.mask);
    const CompiledLiteral* first =
        &activation.rule->body[continuation_.base + static_cast<std::size_t>(bit)];
    if (shop_.reorder && (continuation_.mask & (continuation_.mask - 1)) != 0 && HasRules(*first)) {
      if (const int better = FindExtensional(activation); better >= 0) bit = better;
    }
  }
  continuation_.mask &= ~(std::uint64_t{1} << static_cast<unsigned>(bit));
  const CompiledLiteral& literal =
      activation.rule->body[continuation_.base + static_cast<std::size_t>(bit)];
  if (!IsReady(literal, activation)) {
    delayed_ = shop_.heap->Make(Delayed{&literal, &activation, delayed_});
    return false;
  }
  selected_ = {&literal, &activation};
  return true;
}

bool Machine::SelectDelayed() {
  const Delayed* ready = delayed_;
  while (ready != nullptr && !IsReady(*ready->literal, *ready->activation)) ready = ready->next;
  if (ready == nullptr) return false;
  selected_ = {ready->literal, ready->activation};
  const Delayed* rest = ready->next;
  for (const Delayed* kept = delayed_; kept != ready; kept = kept->next) {
    rest = shop_.heap->Make(Delayed{kept->literal, kept->activation, rest});
  }
  delayed_ = rest;
  return true;
}

void Machine::Leave(const Activation& activation) {
  continuation_ = activation.next;
  const Node& node = *activation.node;
  Choice& choice = choices_[node.choice];
  choice.proved = true;
  if (choice.entry != kNoEntry) shop_.failures->MarkProved(choice.entry, level_);
  // Another proof of a ground goal could bind nothing else.
  if (reach_->reduction_free && node.ground && delayed_ == choice.delayed) {
    choices_.resize(node.choice);
  }
}

Machine::Selection Machine::Select() {
  for (;;) {
    if (delayed_ != nullptr && SelectDelayed()) return Selection::kGoal;
    const Activation& activation = *continuation_.activation;
    const std::size_t size = activation.rule->body.size();
    if (continuation_.mask != 0) {
      if (SelectFrom(activation)) return Selection::kGoal;
    } else if (continuation_.base + kWindow < size) {
      continuation_.base += kWindow;
      continuation_.mask = LowBits(size - continuation_.base);
    } else if (activation.node != nullptr) {
      Leave(activation);
    } else {
      return delayed_ == nullptr ? Selection::kProof : Selection::kStuck;
    }
  }
}

void Machine::BeginLevel(std::uint32_t depth) {
  cut_goals_.clear();
  cut_ = false;
  all_chosen_ = 0;
  level_depth_ = depth;
  level_ = shop_.failures->BeginLevel();
}

void Machine::Begin(const Contrapositive& start) {
  choices_.clear();
  delayed_ = nullptr;
  resting_ = nullptr;
  steps_ = nullptr;
  depth_ = 0;
  chosen_ = 0;
  Word* slots = unifier_.MakeSlots(start.slots);
  const Activation* root =
      shop_.heap->Make(Activation{&start, slots, nullptr, Continuation{}, level_depth_});
  continuation_ = {root, LowBits(start.body.size()), 0};
}

}  // namespace latchwork::pttp

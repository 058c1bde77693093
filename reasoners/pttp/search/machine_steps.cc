// SPDX-License-Identifier: BSD-3-Clause
// The inference steps of the machine, one for each way to solve a subgoal.
#include <algorithm>

#include "reasoners/pttp/search/machine.h"

namespace latchwork::pttp {
namespace {

/// What the first argument of a goal demands of a rule's; 0: nothing.
Word FirstKey(const Node& node) {
  if (node.literal->arity == 0) return 0;
  const Word first = Dereference(node.arguments[0]);
  if (TagOf(first) == Tag::kConstant) return first;
  return TagOf(first) == Tag::kCompound ? *AddressOf(first) : 0;
}

std::uint64_t FullMask(std::size_t count) {
  return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

}  // namespace

bool Machine::TryEquality(Choice& choice) {
  const Node& node = *choice.node;
  if ((*shop_.predicates)[node.literal->predicate].kind != PredicateKind::kEquality) return false;
  choice.phase = Phase::kReduction;
  const Word left = node.arguments[0];
  const Word right = node.arguments[1];
  const bool solved = node.literal->positive ? unifier_.Unify(left, right)
                                             : calculator_.Differ(left, right, shop_.unique_names);
  if (solved) return SolvedAtOnce(choice, {.kind = Step::Kind::kEquality, .node = &node});
  if (!node.literal->positive && !(unifier_.IsGround(left) && unifier_.IsGround(right))) {
    floundered_ = true;
    floundered_predicate_ = node.literal->predicate;
  }
  Retreat(choice);
  choice.phase = Phase::kEquality;
  return false;
}

bool Machine::TryReduction(Choice& choice) {
  const Node& node = *choice.node;
  if (!reach_->MayReduce(Signed(node.literal->predicate, node.literal->positive))) return false;
  while (choice.ancestor != nullptr) {
    const Node& ancestor = *choice.ancestor;
    choice.ancestor = ancestor.parent;
    if (ancestor.literal->predicate != node.literal->predicate ||
        ancestor.literal->positive == node.literal->positive) {
      continue;
    }
    shop_.meter->CountWork();
    bool unified = true;
    for (std::uint32_t i = 0; unified && i < node.literal->arity; ++i) {
      unified = unifier_.Unify(node.arguments[i], ancestor.arguments[i]);
    }
    if (unified) return SolvedAtOnce(choice, {.kind = Step::Kind::kReduction, .node = &node});
    Retreat(choice);
  }
  return false;
}

bool Machine::TryFacts(Choice& choice) {
  const Node& node = *choice.node;
  if (!node.literal->positive) return false;
  const auto tables = shop_.facts->Tables(node.literal->predicate);
  for (;;) {
    while (choice.cursor.row == kNoRow) {
      if (choice.table >= tables.size()) return false;
      const FactStore::Entry& entry = tables[choice.table++];
      if (entry.source->enabled) choice.cursor = entry.table->Find(node.arguments);
    }
    const Word* row = choice.cursor.table->row(choice.cursor.row);
    FactTable::Advance(choice.cursor);
    shop_.meter->CountWork();
    if (shop_.meter->stopped()) return false;
    if (unifier_.UnifyHead(row, node.arguments, node.literal->arity, nullptr, true)) {
      const FactSource* source = tables[choice.table - 1].source;
      return SolvedAtOnce(choice, {.kind = Step::Kind::kFact, .node = &node, .source = source});
    }
    Retreat(choice);
  }
}

bool Machine::TryComputed(Choice& choice) {
  const Node& node = *choice.node;
  if ((*shop_.predicates)[node.literal->predicate].kind != PredicateKind::kAttachment) return false;
  if (choice.computed == nullptr) {
    choice.computed =
        shop_.oracles->Compute(node.literal->predicate, {node.arguments, node.literal->arity});
    if (choice.computed == nullptr) {
      undetermined_ = true;
      return false;
    }
    choice.cursor = choice.computed->rows.Find(node.arguments);
  }
  while (choice.cursor.row != kNoRow) {
    const Word* row = choice.cursor.table->row(choice.cursor.row);
    FactTable::Advance(choice.cursor);
    shop_.meter->CountWork();
    if (unifier_.UnifyHead(row, node.arguments, node.literal->arity, nullptr, true)) {
      if (!node.literal->positive) {
        Retreat(choice);
        return false;
      }
      for (const std::size_t assumption : choice.computed->assumptions) RestOn(assumption);
      return SolvedAtOnce(choice, {.kind = Step::Kind::kAttachment, .node = &node});
    }
    Retreat(choice);
  }
  if (node.literal->positive) return false;
  choice.phase = Phase::kDone;
  for (const std::size_t assumption : choice.computed->assumptions) RestOn(assumption);
  return SolvedAtOnce(choice, {.kind = Step::Kind::kAttachment, .node = &node});
}

bool Machine::Extend(Choice& choice, const Contrapositive& rule) {
  shop_.meter->CountWork();
  const Node& node = *choice.node;
  Word* slots = unifier_.MakeSlots(rule.slots);
  if (!unifier_.UnifyHead(rule.head.arguments, node.arguments, node.literal->arity, slots,
                          rule.linear)) {
    Retreat(choice);
    return false;
  }
  if (node.remaining == 0 && !rule.body.empty()) {
    Retreat(choice);
    choice.cut = true;
    return false;
  }
  const Step step{.kind = Step::Kind::kRule, .node = &node, .rule = &rule, .slots = slots};
  if (rule.body.empty()) return SolvedAtOnce(choice, step);
  Record(step);
  shop_.meter->CountInference();
  const Activation* activation = shop_.heap->Make(
      Activation{&rule, slots, choice.node, choice.continuation, node.remaining - 1});
  continuation_ = {activation, FullMask(rule.body.size()), 0};
  depth_ = std::max(depth_, level_depth_ - activation->remaining);
  return true;
}

bool Machine::TryRules(Choice& choice) {
  const Node& node = *choice.node;
  const auto rules = reach_->RulesFor(Signed(node.literal->predicate, node.literal->positive));
  const Word key = FirstKey(node);
  while (choice.rule < rules.size() && !choice.cut) {
    const Contrapositive& rule = *rules[choice.rule++];
    if (key != 0 && rule.first_key != 0 && key != rule.first_key) continue;
    if (Extend(choice, rule)) return true;
    if (shop_.meter->stopped() || unifier_.exhausted()) return false;
  }
  if (choice.cut) NoteCut(choice.entry);
  return false;
}

bool Machine::TryClosing(Choice& choice) {
  const Node& node = *choice.node;
  const Predicates::Info& info = (*shop_.predicates)[node.literal->predicate];
  if (node.literal->positive || !reach_->closing || !info.minimized) return false;
  choice.phase = Phase::kDone;
  const Closing closing =
      shop_.oracles->Close(node.literal->predicate, {node.arguments, node.literal->arity});
  if (closing.result == Closing::Result::kUndetermined) undetermined_ = true;
  if (closing.result != Closing::Result::kAssumedFalse) {
    choice.phase = Phase::kClosing;
    return false;
  }
  RestOn(closing.assumption);
  Record({.kind = Step::Kind::kAssumption, .node = &node});
  continuation_ = choice.continuation;
  choice.proved = true;
  if (choice.entry != kNoEntry) shop_.failures->MarkProved(choice.entry, level_);
  return true;
}

}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
// The part of the tables that handles terms and computed literals.
#include <algorithm>

#include "reasoners/pttp/tables.h"

namespace latchwork::pttp {

bool Tables::AreSameWithin(Word a, Word b) {
  if (IsNumber(a)) return *AddressOf(a) == *AddressOf(b);
  if (TagOf(a) != Tag::kCompound) return false;
  const Word* block = AddressOf(a);
  const Word* other = AddressOf(b);
  if (block[0] != other[0]) return false;
  for (std::size_t i = ArityOf(block[0]); i > 0; --i) {
    const Word x = Dereference(block[i]);
    const Word y = Dereference(other[i]);
    if (TagOf(x) == Tag::kCompound) return builder_.Identical(a, b);
    if (!SameAtomic(x, y)) return false;
  }
  return true;
}

/// Binds slots of a pattern to parts of a ground value. Patterns are shallow (TableProgram).
bool Tables::Match(Word pattern, Word value, Word* slots) {
  if (TagOf(pattern) == Tag::kSlot) {
    Word& slot = slots[NumberOf(pattern)];
    if (slot != Reference(&slot)) return AreSame(slot, value);
    slot = value;
    return true;
  }
  if (TagOf(pattern) != Tag::kTemplate) return AreSame(pattern, value);
  if (TagOf(value) != Tag::kCompound) return false;
  const Word* block = AddressOf(pattern);
  const Word* other = AddressOf(value);
  if (block[0] != other[0]) return false;
  for (std::size_t i = ArityOf(block[0]); i > 0; --i) {
    if (!Match(block[i], Dereference(other[i]), slots)) return false;
  }
  return true;
}

bool Tables::Matches(const TableStep& step, const Word* row, const Word* goal, Word* slots) {
  for (const std::uint32_t slot : step.binds) slots[slot] = Reference(slots + slot);
  for (std::uint32_t i = 0; i < step.literal->arity; ++i) {
    const bool ground = ((step.ground >> i) & 1U) != 0;
    if (ground ? !AreSame(goal[i], row[i]) : !Match(step.literal->arguments[i], row[i], slots)) {
      return false;
    }
  }
  return true;
}

std::optional<Word> Tables::Value(const TableStep& step, std::size_t argument, const Word* slots,
                                  Calculator& calculator, Unifier& builder) {
  const Word built = BuildGround(step.literal->arguments[argument], slots, builder);
  if (((step.literal->arithmetic >> argument) & 1U) == 0) return built;
  return calculator.Normalize(built);
}

/// The arguments of a step's literal, unbound where they are not ground. Null when one has no
/// value.
const Word* Tables::MakeGoal(const TableStep& step, const Word* slots) {
  const std::uint32_t arity = step.literal->arity;
  Word* goal = stack_.Allocate(arity);
  for (std::uint32_t i = 0; i < arity; ++i) {
    if (((step.ground >> i) & 1U) == 0) {
      goal[i] = Reference(&free_[i]);
      continue;
    }
    const auto value = Value(step, i, slots, calculator_, builder_);
    if (!value) return nullptr;
    goal[i] = *value;
  }
  return goal;
}

Word* Tables::MakeSlots(std::size_t count) {
  Word* slots = stack_.Allocate(count);
  for (std::size_t i = 0; i < count; ++i) slots[i] = Reference(slots + i);
  return slots;
}

/// A copy that lasts.
Word Tables::Keep(Word word) {
  if (IsNumber(word)) {
    Word* box = store_.Allocate(1);
    *box = *AddressOf(word);
    return Tagged(TagOf(word), box);
  }
  if (TagOf(word) != Tag::kCompound) return word;
  Word* whole = store_.Allocate(ArityOf(*AddressOf(word)) + 1);
  copies_.assign(1, {AddressOf(word), whole});
  while (!copies_.empty()) {
    const Copy copy = copies_.back();
    copies_.pop_back();
    copy.to[0] = copy.from[0];
    for (std::size_t i = ArityOf(copy.from[0]); i > 0; --i) {
      const Word part = Dereference(copy.from[i]);
      if (TagOf(part) != Tag::kCompound) {
        copy.to[i] = Keep(part);
        continue;
      }
      Word* block = store_.Allocate(ArityOf(*AddressOf(part)) + 1);
      copies_.push_back({AddressOf(part), block});
      copy.to[i] = Tagged(Tag::kCompound, block);
    }
  }
  return Tagged(Tag::kCompound, whole);
}

const Resting* Tables::Join(const Resting* a, const Resting* b) {
  if (a == nullptr || b == nullptr) return a == nullptr ? b : a;
  for (; b != nullptr; b = b->previous) a = store_.Make(Resting{a, b->assumption});
  return a;
}

bool Tables::Holds(const Frame& frame, const TableStep& step) {
  const CompiledLiteral& literal = *step.literal;
  const Word* goal = MakeGoal(step, frame.slots);
  if (goal == nullptr) return false;
  if (step.kind == TableStep::Kind::kDiffer) {
    return calculator_.Differ(goal[0], goal[1], shop_.unique_names);
  }
  const auto truth =
      Calculator::Decide((*shop_.predicates)[literal.predicate].arithmetic, goal, literal.arity);
  return truth && *truth == literal.positive;
}

bool Tables::TryUnify(const Frame& frame, std::size_t step) {
  const TableStep& equation = frame.plan->steps[step];
  if (!Count()) return false;
  const std::size_t given = (equation.ground & 1U) != 0 ? 0 : 1;
  const auto value = Value(equation, given, frame.slots, keeping_calculator_, keeper_);
  if (!value) return true;
  for (const std::uint32_t slot : equation.binds) frame.slots[slot] = Reference(frame.slots + slot);
  const std::size_t other = 1 - given;
  if (((equation.ground >> other) & 1U) != 0) {
    const auto second = Value(equation, other, frame.slots, calculator_, builder_);
    if (!second || !AreSame(*value, *second)) return true;
  } else if (!Match(equation.literal->arguments[other], *value, frame.slots)) {
    return true;
  }
  shop_.meter->CountInference();
  return Continue(frame, step + 1);
}

bool Tables::TryComputed(const Frame& frame, std::size_t step) {
  const TableStep& call = frame.plan->steps[step];
  const CompiledLiteral& literal = *call.literal;
  const Word* goal = MakeGoal(call, frame.slots);
  if (goal == nullptr) return true;
  Computed* computed = shop_.oracles->Compute(literal.predicate, {goal, literal.arity});
  if (computed == nullptr) return Unfit(*frame.run);
  Frame next = frame;
  for (const std::size_t assumption : computed->assumptions) {
    next.resting = store_.Make(Resting{next.resting, assumption});
  }
  if (literal.positive) return TryRows(next, step, computed->rows, {}, goal);
  for (auto cursor = computed->rows.Find(goal); cursor.row != kNoRow; FactTable::Advance(cursor)) {
    if (Matches(call, computed->rows.row(cursor.row), goal, frame.slots)) return true;
  }
  shop_.meter->CountInference();
  return Continue(next, step + 1);
}

bool Tables::TryClosing(const Frame& frame, std::size_t step) {
  const TableStep& closing = frame.plan->steps[step];
  if (!Count()) return false;
  const Word* goal = MakeGoal(closing, frame.slots);
  if (goal == nullptr) return true;
  const CompiledLiteral& literal = *closing.literal;
  const Closing closed = shop_.oracles->Close(literal.predicate, {goal, literal.arity});
  if (closed.result == Closing::Result::kUndetermined) return Unfit(*frame.run);
  if (closed.result == Closing::Result::kProved) return true;
  Frame next = frame;
  next.resting = store_.Make(Resting{frame.resting, closed.assumption});
  return Continue(next, step + 1);
}

}  // namespace latchwork::pttp

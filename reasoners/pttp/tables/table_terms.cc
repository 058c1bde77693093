// SPDX-License-Identifier: BSD-3-Clause
// The part of the tables that handles terms and numbers.
#include <array>

#include "reasoners/pttp/tables/tables.h"

namespace latchwork::pttp {
namespace {

/// A template with its slots replaced. Templates are shallow (TableProgram).
Word Build(Word pattern, const Word* slots, Arena& arena) {
  const Word* block = AddressOf(pattern);
  const std::size_t arity = ArityOf(block[0]);
  Word* copy = arena.Allocate(arity + 1);
  copy[0] = block[0];
  for (std::size_t i = 1; i <= arity; ++i) {
    const Word part = block[i];
    copy[i] = TagOf(part) == Tag::kSlot       ? slots[NumberOf(part)]
              : TagOf(part) == Tag::kTemplate ? Build(part, slots, arena)
                                              : part;
  }
  return Tagged(Tag::kCompound, copy);
}

}  // namespace

bool Tables::AreSameWithin(Word a, Word b) {
  if (IsNumber(a)) return *AddressOf(a) == *AddressOf(b);
  if (TagOf(a) != Tag::kCompound) return false;
  const Word* block = AddressOf(a);
  const Word* other = AddressOf(b);
  if (block[0] != other[0]) return false;
  for (std::size_t i = ArityOf(block[0]); i > 0; --i) {
    const Word x = Dereference(block[i]);
    const Word y = Dereference(other[i]);
    if (TagOf(x) == Tag::kCompound) return comparer_.Identical(a, b);
    if (!SameAtomic(x, y)) return false;
  }
  return true;
}

bool Tables::MatchParts(const MatchCode& pattern, const Word* given, Word* slots) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): written before it is read
  std::array<Word, MatchCode::kMostParts> parts;
  Word* end = parts.data();
  for (const MatchStep& step : pattern.steps) {
    const Word value = step.of_part ? parts[step.source] : given[step.source];
    switch (step.kind) {
      case MatchStep::Kind::kBind:
        slots[step.slot] = value;
        break;
      case MatchStep::Kind::kSame:
        if (!AreSame(slots[step.slot], value)) return false;
        break;
      case MatchStep::Kind::kEqual:
        if (!AreSame(step.word, value)) return false;
        break;
      case MatchStep::Kind::kOpen: {
        if (TagOf(value) != Tag::kCompound || *AddressOf(value) != step.word) return false;
        const Word* block = AddressOf(value);
        for (std::size_t i = 1; i <= ArityOf(step.word); ++i) *end++ = Dereference(block[i]);
      }
    }
  }
  return true;
}

bool Tables::Calculate(const Operand& operand, const Word* slots, Number& number) {
  Number* top = numbers_.data();
  for (const Instruction& instruction : operand.calculation) {
    switch (instruction.kind) {
      case Instruction::Kind::kSlot: {
        const Word value = slots[instruction.operand];
        // A fact may hold an interpreted function.
        if (!IsNumber(value)) return TagOf(value) == Tag::kCompound && Mix(operand, slots, number);
        *top++ = Number::In(value);
        break;
      }
      case Instruction::Kind::kNumber:
        *top++ = instruction.number;
        break;
      case Instruction::Kind::kApply:
        top -= instruction.operand;
        if (!Calculator::Apply(instruction.function, top, instruction.operand, *top)) return false;
        ++top;
    }
  }
  number = top[-1];
  return true;
}

/// The same step by step, for words that a calculation does not provide for.
bool Tables::Mix(const Operand& operand, const Word* slots, Number& number) {
  const Arena::Mark mark = stack_.arena.mark();
  Word value = 0;
  const bool is_number = MakeMixed(operand, slots, stack_, value) && IsNumber(value);
  if (is_number) number = Number::In(value);
  stack_.arena.Release(mark);
  return is_number;
}

bool Tables::MakeMixed(const Operand& operand, const Word* slots, Maker& maker, Word& value) {
  const bool is_template = TagOf(operand.word) == Tag::kTemplate;
  const auto result = maker.calculator.Normalize(
      is_template ? Build(operand.word, slots, maker.arena) : operand.word);
  if (result) value = *result;
  return result.has_value();
}

bool Tables::MakeWord(const Operand& operand, const Word* slots, Maker& maker, Word& value) {
  switch (operand.kind) {
    case Operand::Kind::kWord:
      value = operand.word;
      return true;
    case Operand::Kind::kSlot:
      value = slots[operand.slot];
      return true;
    case Operand::Kind::kTemplate:
      value = Build(operand.word, slots, maker.arena);
      return true;
    case Operand::Kind::kCalculation: {
      Number number;
      if (!Calculate(operand, slots, number)) return false;
      value = Box(number, maker.arena);
      return true;
    }
    case Operand::Kind::kMixed:
      break;
  }
  return MakeMixed(operand, slots, maker, value);
}

const Resting* Tables::Join(const Resting* a, const Resting* b) {
  if (a == nullptr || b == nullptr) return a == nullptr ? b : a;
  for (; b != nullptr; b = b->previous) a = store_.arena.Make(Resting{a, b->assumption});
  return a;
}

bool Tables::Differ(const TableStep& step, const Word* slots) {
  const Arena::Mark mark = stack_.arena.mark();
  const Word* sides = ValuesOf(step, slots);
  const bool differ =
      sides != nullptr && stack_.calculator.Differ(sides[0], sides[1], shop_.unique_names);
  stack_.arena.Release(mark);
  return differ;
}

bool Tables::Compare(const TableStep& step, const Word* slots) {
  std::array<Number, Calculator::kMostArguments> numbers;
  for (std::uint32_t i = 0; i < step.arity; ++i) {
    if (!ReadNumber(step.operands[i], slots, numbers[i])) return false;
  }
  return Calculator::Decide(step.comparison, numbers.data(), step.arity) == step.positive;
}

}  // namespace latchwork::pttp

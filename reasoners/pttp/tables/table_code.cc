// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tables/table_code.h"

#include <algorithm>

namespace latchwork::pttp {
namespace {

/// False when something other than numbers, slots and interpreted functions is in the word.
bool AddCalculation(const Functors& functors, Word word, int depth,
                    std::vector<Instruction>& code) {
  if (TagOf(word) == Tag::kSlot) {
    code.push_back({Instruction::Kind::kSlot, {}, NumberOf(word), {}});
    return true;
  }
  if (IsNumber(word)) {
    code.push_back({Instruction::Kind::kNumber, {}, 0, Number::In(word)});
    return true;
  }
  if ((TagOf(word) != Tag::kTemplate && TagOf(word) != Tag::kCompound) ||
      depth == kDeepestTemplate) {
    return false;
  }
  const Word* block = AddressOf(word);
  const auto function = functors[NumberOf(block[0])].function;
  const auto arity = static_cast<std::uint32_t>(ArityOf(block[0]));
  if (!function || arity > Calculator::kMostArguments) return false;
  for (std::uint32_t i = 1; i <= arity; ++i) {
    if (!AddCalculation(functors, block[i], depth + 1, code)) return false;
  }
  code.push_back({Instruction::Kind::kApply, *function, arity, {}});
  return true;
}

}  // namespace

bool CodeMaker::IsBound(Word word) const {
  if (TagOf(word) == Tag::kSlot) return bound_[NumberOf(word)];
  if (TagOf(word) != Tag::kTemplate) return true;
  const Word* block = AddressOf(word);
  return std::all_of(block + 1, block + 1 + ArityOf(block[0]),
                     [&](Word part) { return IsBound(part); });
}

Operand CodeMaker::MakeOperand(Word word, std::uint32_t argument, bool computed) const {
  using Kind = Operand::Kind;
  Operand operand{Kind::kWord, 0, argument, word, {}};
  if (TagOf(word) == Tag::kSlot) {
    operand.kind = Kind::kSlot;
    operand.slot = NumberOf(word);
  } else if (computed) {
    const bool whole = AddCalculation(*functors_, word, 0, operand.calculation);
    operand.kind = whole ? Kind::kCalculation : Kind::kMixed;
  } else if (TagOf(word) == Tag::kTemplate) {
    operand.kind = Kind::kTemplate;
  }
  return operand;
}

void CodeMaker::AddMatch(Word word, std::uint32_t source, bool of_part, MatchCode& pattern) {
  using Kind = MatchStep::Kind;
  if (TagOf(word) == Tag::kSlot) {
    const std::uint32_t slot = NumberOf(word);
    const Kind kind = bound_[slot] ? Kind::kSame : Kind::kBind;
    bound_[slot] = true;
    pattern.binds_only = pattern.binds_only && kind == Kind::kBind && !of_part;
    pattern.steps.push_back({kind, of_part, source, slot, 0});
    return;
  }
  pattern.binds_only = false;
  if (TagOf(word) != Tag::kTemplate) {
    pattern.steps.push_back({Kind::kEqual, of_part, source, 0, word});
    return;
  }
  const Word* block = AddressOf(word);
  const auto arity = static_cast<std::uint32_t>(ArityOf(block[0]));
  const std::uint32_t first = pattern.parts;
  failed_ = failed_ || arity > MatchCode::kMostParts - first;
  if (failed_) return;
  pattern.steps.push_back({Kind::kOpen, of_part, source, 0, block[0]});
  pattern.parts += arity;
  for (std::uint32_t i = 0; i < arity; ++i) AddMatch(block[i + 1], first + i, true, pattern);
}

}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tableau/literal_coder.h"

#include <algorithm>

#include "reasoners/pttp/tableau/bindings.h"

namespace latchwork::pttp {

TermCode LiteralCoder::Code(std::uint32_t arguments, std::uint32_t arity, std::uint32_t& words) {
  blocks_.clear();
  code_of_.clear();
  for (std::uint32_t i = arity; i > 0; --i) List(cells_[arguments + i - 1], i - 1);
  words = 0;
  for (auto block = blocks_.rbegin(); block != blocks_.rend(); ++block) {
    block->start = words;
    words += kBlockHeader + BlockOfCell(cells_.data(), block->cell)[1];
  }
  TermCode code;
  code.first = static_cast<std::uint32_t>(codes_.size());
  Emit(words);
  code.end = static_cast<std::uint32_t>(codes_.size());
  return code;
}

/// Wholes before parts; the parts of a part stay together.
void LiteralCoder::List(Cell argument, std::uint32_t number) {
  std::vector<Block> visits{{argument, kLiteral, number, 0}};
  while (!visits.empty()) {
    const Block visit = visits.back();
    visits.pop_back();
    if (TagOfCell(visit.cell) != kOpenTag) continue;
    const auto whole = static_cast<std::uint32_t>(blocks_.size());
    blocks_.push_back(visit);
    const Cell* block = BlockOfCell(cells_.data(), visit.cell);
    for (std::uint32_t i = 0; i < block[1]; ++i) visits.push_back({block[2 + i], whole, i, 0});
  }
}

void LiteralCoder::Emit(std::uint32_t words) {
  std::vector<std::uint32_t> first(blocks_.size(), kLiteral);
  for (std::size_t number = blocks_.size(); number > 0; --number) {
    const Block& made = blocks_[number - 1];
    const auto here = static_cast<std::uint32_t>(codes_.size());
    first[number - 1] = std::min(first[number - 1], here);
    const bool outermost = made.parent == kLiteral;
    const std::uint32_t home = outermost ? words : blocks_[made.parent].start + kBlockHeader;
    const Cell* block = BlockOfCell(cells_.data(), made.cell);
    codes_.insert(codes_.end(), {block[0], block[1], home + made.argument - made.start});
    codes_.insert(codes_.end(), block + 2, block + 2 + block[1]);
    code_of_[made.cell] = {first[number - 1], static_cast<std::uint32_t>(codes_.size())};
    if (!outermost) first[made.parent] = std::min(first[made.parent], first[number - 1]);
  }
}

void LiteralCoder::AddHead(std::uint32_t arguments, std::uint32_t arity, std::uint32_t slots) {
  met_.assign(slots, false);
  AddOperations(cells_.data() + arguments, arity, 0);
  operations_.push_back({});
}

/// Whether all variables occur here first, and once.
bool LiteralCoder::AddOperations(const Cell* arguments, std::uint32_t count, std::uint32_t nested) {
  bool all_new = true;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Cell cell = arguments[i];
    if (TagOfCell(cell) == kOpenTag) {
      const bool is_new = AddOpen(cell, i + 1 == count, nested);
      all_new = all_new && is_new;
      continue;
    }
    HeadOperation operation;
    operation.step = HeadStep::kGround;
    operation.cell = cell;
    if (IsVariable(cell)) {
      const bool is_new = Meet(cell);
      operation.step = is_new ? HeadStep::kFirst : HeadStep::kAgain;
      all_new = all_new && is_new;
    }
    operations_.push_back(operation);
  }
  return all_new;
}

bool LiteralCoder::AddOpen(Cell cell, bool last, std::uint32_t nested) {
  const std::size_t at = operations_.size();
  HeadOperation operation;
  operation.step = HeadStep::kOpen;
  operation.last = last;
  operation.cell = cell;
  operation.code = code_of_[cell];
  if (nested == Bindings::kMostNested) {
    operation.step = HeadStep::kDeep;
    MeetAll(cell);
    operations_.push_back(operation);
    return false;
  }
  const Cell* block = BlockOfCell(cells_.data(), cell);
  operation.cell = block[0];
  operations_.push_back(operation);
  const bool all_new = AddOperations(block + 2, block[1], nested + 1);
  if (!last) {
    operations_.push_back({});
    operations_.back().step = HeadStep::kUp;
  }
  operations_[at].all_new = all_new;
  operations_[at].skip = static_cast<std::uint32_t>(operations_.size() - at - 1);
  return all_new;
}

bool LiteralCoder::Meet(Cell variable) {
  const bool met = met_[SlotOfCell(variable)];
  met_[SlotOfCell(variable)] = true;
  return !met;
}

void LiteralCoder::MeetAll(Cell term) {
  std::vector<Cell> visits{term};
  while (!visits.empty()) {
    const Cell cell = visits.back();
    visits.pop_back();
    if (IsVariable(cell)) {
      Meet(cell);
    } else if (!IsGround(cell)) {
      const Cell* block = BlockOfCell(cells_.data(), cell);
      visits.insert(visits.end(), block + 2, block + 2 + block[1]);
    }
  }
}

}  // namespace latchwork::pttp

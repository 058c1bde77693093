// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tableau/bindings.h"

#include <algorithm>
#include <array>

namespace latchwork::pttp {

Bindings::Bindings(const Matrix& matrix) : codes_(matrix.codes()) {
  const std::span<const Cell> cells = matrix.all_cells();
  first_ = static_cast<std::uint32_t>(cells.size());
  std::copy(cells.begin(), cells.end(), cells_.Extend(cells.size()));
}

Cell Bindings::Make(TermCode made_by, std::uint32_t base) {
  const Cell* code = codes_ + made_by.first;
  const Cell* const end = codes_ + made_by.end;
  Cell* block = cells_.data() + size();
  Cell made = 0;
  while (code != end) {
    const std::uint32_t arity = code[1];
    const std::uint32_t home = code[2];
    block[1] = code[0];
    block[2] = arity;
    code += kBlockHeader;
    Cell* const arguments = block + kBlockHeader;
    Cell ground = kGroundTag;
    for (std::uint32_t i = 0; i < arity; ++i) {
      ground &= MakeArgument(code[i], base, arguments + i);
    }
    if (ground != 0) block[0] = HashOf(block[1], arguments, arity);
    made =
        (static_cast<Cell>(block + 1 - cells_.data()) << 2U) | (ground != 0 ? kBuiltTag : kOpenTag);
    block[home] = made;
    code += arity;
    block = arguments + arity;
  }
  cells_.Extend(static_cast<std::size_t>(block - (cells_.data() + size())));
  return made;
}

bool Bindings::MeetOpen(const HeadOperation& operation, std::uint32_t base, Cell variable) {
  const Cell made = Make(operation.code, base);
  if (!operation.all_new && !IsGround(made) && Occurs(variable, made)) return false;
  Bind(variable, made);
  return true;
}

bool Bindings::RunHead(const HeadOperation* operation, std::uint32_t base, std::uint32_t at) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): written before it is read
  std::array<std::uint32_t, kMostNested> up;
  std::uint32_t nested = 0;
  for (;; ++operation) {
    if (operation->step == HeadStep::kFirst) {
      const Cell term = cells_[at];
      cells_[base + (operation->cell >> 2U)] = term != 0 ? term : VariableAt(at);
      ++at;
      continue;
    }
    switch (operation->step) {
      case HeadStep::kFirst:
        break;
      case HeadStep::kAgain:
        if (!Unify(ArgumentAt(base + (operation->cell >> 2U)), ArgumentAt(at))) return false;
        ++at;
        break;
      case HeadStep::kGround:
        if (!UnifyGround(operation->cell, ArgumentAt(at))) return false;
        ++at;
        break;
      case HeadStep::kOpen: {
        const Cell term = ArgumentAt(at);
        if (IsVariable(term)) {
          if (!MeetOpen(*operation, base, term)) return false;
          ++at;
          operation += operation->skip;
          break;
        }
        if (*Block(term) != operation->cell) return false;
        if (!operation->last) up[nested++] = at + 1;
        at = (term >> 2U) + 2;
        break;
      }
      case HeadStep::kDeep:
        if (!Unify(Make(operation->code, base), ArgumentAt(at))) return false;
        ++at;
        break;
      case HeadStep::kUp:
        at = up[--nested];
        break;
      case HeadStep::kDone:
        return true;
    }
  }
}

/// Terms from before the goal do not lead to its variables as long as no variable from before it
/// was bound.
bool Bindings::Occurs(Cell variable, Cell term) {
  const Cell oldest = PlaceOf(variable) >= goal_ && !outside_bound_ ? goal_ << 2U : 0;
  if (term < oldest) return false;
  visits_.Truncate(0);
  visits_.Push(term);
  while (!visits_.empty()) {
    const Cell* block = Block(visits_.Pop());
    if (!Spend(block[1])) return true;
    const auto arguments = static_cast<std::uint32_t>(block - cells_.data()) + 2;
    for (std::uint32_t i = block[1]; i > 0; --i) {
      const Cell argument = ArgumentAt(arguments + i - 1);
      if (IsGround(argument)) continue;
      if (argument == variable) return true;
      if (!IsVariable(argument) && argument >= oldest) visits_.Push(argument);
    }
  }
  return false;
}

/// Goes through two compound terms side by side; `agree` decides where one of them is a variable.
template <typename Agree>
bool Bindings::AgreeBelow(Cell a, Cell b, const Agree& agree) {
  pairs_.Truncate(0);
  pairs_.Push({a, b});
  while (!pairs_.empty()) {
    const auto [left, right] = pairs_.Pop();
    const Cell* block = Block(left);
    if (!Spend(block[1])) return false;
    const std::uint32_t x = (left >> 2U) + 2;
    const std::uint32_t y = (right >> 2U) + 2;
    const std::uint32_t arity = block[1];
    for (std::uint32_t i = 0; i < arity; ++i) {
      const Cell p = ArgumentAt(x + i);
      const Cell q = ArgumentAt(y + i);
      if (p == q) continue;
      if (IsVariable(p) || IsVariable(q)) {
        if (!agree(p, q)) return false;
      } else {
        if (Differ(p, q)) return false;
        pairs_.Push({p, q});
      }
    }
  }
  return true;
}

bool Bindings::UnifyBelow(Cell a, Cell b) {
  return AgreeBelow(a, b, [this](Cell p, Cell q) { return Unify(p, q); });
}

bool Bindings::SameBelow(Cell a, Cell b) {
  return AgreeBelow(a, b, [](Cell /*p*/, Cell /*q*/) { return false; });
}

}  // namespace latchwork::pttp

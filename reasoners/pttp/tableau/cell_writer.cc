// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tableau/cell_writer.h"

#include <algorithm>

namespace latchwork::pttp {

using logic::Term;

Cell CellWriter::Write(const Term& term) {
  if (term.is_variable()) return CellOfSlot(term.variable());
  std::vector<Pending> stack{Begin(term)};
  for (;;) {
    Pending& top = stack.back();
    const std::size_t next = top.block.size() - 1;
    if (next < top.term->arguments().size()) {
      const Term& argument = top.term->arguments()[next];
      if (argument.is_variable()) {
        top.block.push_back(CellOfSlot(argument.variable()));
      } else {
        stack.push_back(Begin(argument));
      }
      continue;
    }
    const Cell made = WriteBlock(std::move(top.block));
    stack.pop_back();
    if (stack.empty()) return made;
    stack.back().block.push_back(made);
  }
}

CellWriter::Pending CellWriter::Begin(const Term& term) {
  const bool compound = term.kind() == Term::Kind::kCompound;
  const Term head = compound ? Term::Constant(term.symbol()) : term;
  const auto arity = static_cast<std::uint32_t>(term.arguments().size());
  const auto [place, added] =
      numbers_.try_emplace({head, arity}, static_cast<std::uint32_t>(functors_.size()));
  if (added) functors_.push_back(head);
  return {&term, {place->second}};
}

Cell CellWriter::WriteBlock(std::vector<Cell> block) {
  const bool ground = std::all_of(block.begin() + 1, block.end(), IsGround);
  if (ground) {
    if (const auto known = ground_.find(block); known != ground_.end()) return known->second;
  }
  std::uint32_t hash = block.front();
  if (ground) {
    for (auto argument = block.begin() + 1; argument != block.end(); ++argument) {
      hash = AddToHash(hash, HashOfGround(cells_.data(), *argument));
    }
  }
  cells_.push_back(hash);
  const auto offset = static_cast<std::uint32_t>(cells_.size());
  cells_.push_back(block.front());
  cells_.push_back(static_cast<Cell>(block.size() - 1));
  cells_.insert(cells_.end(), block.begin() + 1, block.end());
  const Cell made = (offset << 2U) | (ground ? kGroundTag : kOpenTag);
  if (ground) ground_.emplace(std::move(block), made);
  return made;
}

}  // namespace latchwork::pttp

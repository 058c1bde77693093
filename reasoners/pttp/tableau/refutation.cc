// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "reasoners/pttp/tableau/tableau.h"

namespace latchwork::pttp {

/// A term of the matrix, as an instance of the copy at `base`.
logic::Term Tableau::Export(Cell cell, std::uint32_t base, std::vector<Cell>& variables) const {
  struct Pending {
    Cell cell;
    bool of_matrix;
    std::vector<logic::Term> arguments;
  };
  std::vector<Pending> stack;
  const auto push = [&](Cell term, bool of_matrix) {
    const bool slot = of_matrix && IsVariable(term);
    stack.push_back(
        {slot ? bindings_.ArgumentAt(base + (term >> 2U)) : term, of_matrix && !slot, {}});
  };
  const auto leaf = [&](Cell variable) {
    auto place = std::find(variables.begin(), variables.end(), variable);
    if (place == variables.end()) place = variables.insert(place, variable);
    return logic::Term::Var(static_cast<logic::Variable>(place - variables.begin()));
  };
  push(cell, true);
  for (;;) {
    Pending& top = stack.back();
    logic::Term made;
    if (IsVariable(top.cell)) {
      made = leaf(top.cell);
    } else {
      const Cell* block = bindings_.Block(top.cell);
      const auto next = static_cast<std::uint32_t>(top.arguments.size());
      if (next < block[1]) {
        push(top.of_matrix ? block[2 + next] : bindings_.ArgumentAt((top.cell >> 2U) + 2 + next),
             top.of_matrix);
        continue;
      }
      made = matrix_.functor(block[0]);
      if (block[1] > 0) made = logic::Term::Compound(made.symbol(), std::move(top.arguments));
    }
    stack.pop_back();
    if (stack.empty()) return made;
    stack.back().arguments.push_back(std::move(made));
  }
}

ClauseInstance Tableau::InstanceOf(const Step& step, std::vector<Cell>& variables) const {
  const Entry& entry = *step.entry;
  ClauseInstance instance{entry.clause, {}, {}};
  for (const MatrixLiteral& literal : matrix_.ClauseLiterals(entry.clause)) {
    std::vector<logic::Term> arguments;
    for (std::uint32_t i = 0; i < literal.arity; ++i) {
      arguments.push_back(Export(matrix_.cells()[literal.arguments + i], step.base, variables));
    }
    instance.literals.push_back(
        {(literal.key & 1U) != 0, logic::Atom(matrix_.predicate(literal.key), arguments)});
  }
  for (std::uint32_t slot = 0; slot < entry.slots; ++slot) {
    instance.values.push_back(Export(CellOfSlot(slot), step.base, variables));
  }
  return instance;
}

std::vector<ClauseInstance> Tableau::Refutation() const {
  std::vector<ClauseInstance> result;
  std::vector<Cell> variables;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    result.push_back(InstanceOf(steps_[i], variables));
  }
  return result;
}

}  // namespace latchwork::pttp

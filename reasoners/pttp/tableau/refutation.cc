// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "reasoners/pttp/tableau/tableau.h"

namespace latchwork::pttp {

logic::Term Tableau::Export(Instance term, std::vector<std::uint32_t>& variables) const {
  struct Pending {
    Instance term;
    std::vector<logic::Term> arguments;
  };
  std::vector<Pending> stack;
  const auto leaf = [&](std::uint32_t variable) {
    auto place = std::find(variables.begin(), variables.end(), variable);
    if (place == variables.end()) place = variables.insert(place, variable);
    return logic::Term::Var(static_cast<logic::Variable>(place - variables.begin()));
  };
  stack.push_back({bindings_.Resolve(term), {}});
  for (;;) {
    Pending& top = stack.back();
    logic::Term made;
    if (IsVariable(top.term.cell)) {
      made = leaf(Bindings::VariableOf(top.term));
    } else {
      const Cell* block = BlockOfCell(matrix_.cells(), top.term.cell);
      if (top.arguments.size() < block[1]) {
        stack.push_back({bindings_.Resolve({block[2 + top.arguments.size()], top.term.base}), {}});
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

ClauseInstance Tableau::InstanceOf(const Step& step, std::vector<std::uint32_t>& variables) const {
  const Entry& entry = *step.entry;
  ClauseInstance instance{entry.clause, {}, {}};
  for (const MatrixLiteral& literal : matrix_.ClauseLiterals(entry.clause)) {
    std::vector<logic::Term> arguments;
    for (std::uint32_t i = 0; i < literal.arity; ++i) {
      arguments.push_back(Export({matrix_.cells()[literal.arguments + i], step.base}, variables));
    }
    instance.literals.push_back(
        {(literal.key & 1U) != 0, logic::Atom(matrix_.predicate(literal.key), arguments)});
  }
  for (std::uint32_t slot = 0; slot < entry.slots; ++slot) {
    instance.values.push_back(Export({CellOfSlot(slot), step.base}, variables));
  }
  return instance;
}

std::vector<ClauseInstance> Tableau::Refutation() const {
  std::vector<ClauseInstance> result;
  std::vector<std::uint32_t> variables;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    result.push_back(InstanceOf(steps_[i], variables));
  }
  return result;
}

}  // namespace latchwork::pttp

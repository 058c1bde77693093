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
  const auto leaf = [&](Instance atom) {
    if (TagOfCell(atom.cell) == kConstantTag) return matrix_.functor(OffsetOfCell(atom.cell));
    const std::uint32_t variable = atom.base + SlotOfCell(atom.cell);
    auto place = std::find(variables.begin(), variables.end(), variable);
    if (place == variables.end()) place = variables.insert(place, variable);
    return logic::Term::Var(static_cast<logic::Variable>(place - variables.begin()));
  };
  term = bindings_.Resolve(term);
  if (TagOfCell(term.cell) < kOpenTag) return leaf(term);
  stack.push_back({term, {}});
  for (;;) {
    Pending& top = stack.back();
    const Cell* block = matrix_.cells() + OffsetOfCell(top.term.cell);
    if (top.arguments.size() < block[1]) {
      const Instance next = bindings_.Resolve({block[2 + top.arguments.size()], top.term.base});
      if (TagOfCell(next.cell) < kOpenTag) {
        top.arguments.push_back(leaf(next));
      } else {
        stack.push_back({next, {}});
      }
      continue;
    }
    logic::Term made =
        logic::Term::Compound(matrix_.functor(block[0]).symbol(), std::move(top.arguments));
    stack.pop_back();
    if (stack.empty()) return made;
    stack.back().arguments.push_back(std::move(made));
  }
}

ClauseInstance Tableau::InstanceOf(const Step& step, std::vector<std::uint32_t>& variables) const {
  const Entry& entry = matrix_.entry(step.entry);
  ClauseInstance instance{entry.clause, {}, {}};
  for (const std::uint32_t index : matrix_.ClauseLiterals(entry.clause)) {
    const MatrixLiteral& literal = matrix_.literal(index);
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

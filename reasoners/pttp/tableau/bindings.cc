// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tableau/bindings.h"

namespace latchwork::pttp {

bool Bindings::Occurs(std::uint32_t variable, Instance term) {
  visits_.Truncate(0);
  visits_.Push(term);
  while (!visits_.empty()) {
    const Instance current = visits_.Pop();
    const Cell* block = BlockOfCell(cells_, current.cell);
    if (!Spend(block[1])) return true;
    for (std::uint32_t i = block[1]; i > 0; --i) {
      const Instance argument = Resolve({block[1 + i], current.base});
      if (IsGround(argument.cell)) continue;
      if (!IsVariable(argument.cell)) {
        visits_.Push(argument);
      } else if (VariableOf(argument) == variable) {
        return true;
      }
    }
  }
  return false;
}

/// Goes through two compound terms side by side; `agree` decides where one of them is a variable.
template <typename Agree>
bool Bindings::AgreeBelow(Instance a, Instance b, const Agree& agree) {
  pairs_.Truncate(0);
  pairs_.Push({a, b});
  while (!pairs_.empty()) {
    const auto [left, right] = pairs_.Pop();
    const Cell* x = BlockOfCell(cells_, left.cell);
    const Cell* y = BlockOfCell(cells_, right.cell);
    if (!Spend(x[1])) return false;
    for (std::uint32_t i = 0; i < x[1]; ++i) {
      const Instance p = Resolve({x[2 + i], left.base});
      const Instance q = Resolve({y[2 + i], right.base});
      if (SamePlace(p, q)) continue;
      if (IsVariable(p.cell) || IsVariable(q.cell)) {
        if (!agree(p, q)) return false;
      } else {
        if (DifferAtOnce(p, q)) return false;
        pairs_.Push({p, q});
      }
    }
  }
  return true;
}

bool Bindings::UnifyBelow(Instance a, Instance b) {
  return AgreeBelow(a, b, [this](Instance p, Instance q) { return UnifyTerms(p, q); });
}

bool Bindings::SameBelow(Instance a, Instance b) {
  return AgreeBelow(a, b, [](Instance /*p*/, Instance /*q*/) { return false; });
}

}  // namespace latchwork::pttp

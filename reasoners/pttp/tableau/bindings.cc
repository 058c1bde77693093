// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tableau/bindings.h"

namespace latchwork::pttp {

bool Bindings::Occurs(std::uint32_t variable, Instance term) {
  visits_.Truncate(0);
  visits_.Push(term);
  while (!visits_.empty()) {
    const Instance current = visits_.Pop();
    const Cell* block = cells_ + OffsetOfCell(current.cell);
    if (!Spend(block[1])) return true;
    for (std::uint32_t i = block[1]; i > 0; --i) {
      const Instance argument = Resolve({block[1 + i], current.base});
      if (TagOfCell(argument.cell) == kOpenTag) {
        visits_.Push(argument);
      } else if (TagOfCell(argument.cell) == kVariableTag && VariableOf(argument) == variable) {
        return true;
      }
    }
  }
  return false;
}

/// Goes through two compound terms side by side; `agree` decides where one of them is none.
template <typename Agree>
bool Bindings::AgreeBelow(Instance a, Instance b, const Agree& agree) {
  pairs_.Truncate(0);
  pairs_.Push({a, b});
  while (!pairs_.empty()) {
    const auto [left, right] = pairs_.Pop();
    const Cell* x = cells_ + OffsetOfCell(left.cell);
    const Cell* y = cells_ + OffsetOfCell(right.cell);
    if (x[0] != y[0] || !Spend(x[1])) return false;
    for (std::uint32_t i = 0; i < x[1]; ++i) {
      const Instance p = Resolve({x[2 + i], left.base});
      const Instance q = Resolve({y[2 + i], right.base});
      const bool p_ground = TagOfCell(p.cell) == kGroundTag;
      if (TagOfCell(p.cell) < kOpenTag || TagOfCell(q.cell) < kOpenTag) {
        if (!agree(p, q)) return false;
      } else if (p_ground && TagOfCell(q.cell) == kGroundTag) {
        if (p.cell != q.cell) return false;
      } else if (p.cell != q.cell || p.base != q.base) {
        pairs_.Push({p, q});
      }
    }
  }
  return true;
}

bool Bindings::UnifyCompounds(Instance a, Instance b) {
  return AgreeBelow(a, b, [this](Instance p, Instance q) { return UnifyTerms(p, q); });
}

bool Bindings::SameCompounds(Instance a, Instance b) {
  return AgreeBelow(a, b, [this](Instance p, Instance q) { return SameTerms(p, q); });
}

}  // namespace latchwork::pttp

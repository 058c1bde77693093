// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/literal_selection.h"

#include <algorithm>
#include <cstdint>

namespace latchwork::pttp::saturation {
namespace {

void MarkMaximal(Ordering& ordering, std::span<Literal> literals) {
  for (Literal& literal : literals) {
    literal.eligible = std::ranges::none_of(literals, [&](const Literal& other) {
      return &other != &literal && ordering.Compare(other, literal) == Order::kGreater;
    });
  }
}

bool HasUniquePositive(std::span<const Literal> literals) {
  const auto marked = [](const Literal& literal) { return literal.eligible; };
  return std::ranges::count_if(literals, marked) == 1 &&
         std::ranges::find_if(literals, marked)->positive;
}

std::uint32_t Size(const Terms& terms, const Literal& literal) {
  return terms.size(literal.left) + (literal.is_equation() ? terms.size(literal.right) : 0);
}

Literal* Choose(const Terms& terms, Selection selection, std::span<Literal> literals) {
  Literal* best = nullptr;
  for (Literal& literal : literals) {
    if (literal.positive) continue;
    const bool better =
        best == nullptr ||
        (selection == Selection::kSmallest && Size(terms, literal) < Size(terms, *best)) ||
        (selection != Selection::kSmallest && selection != Selection::kFirst &&
         Size(terms, literal) > Size(terms, *best));
    if (better) best = &literal;
  }
  return best;
}

}  // namespace

void MarkEligible(const Terms& terms, Ordering& ordering, Selection selection,
                  std::span<Literal> literals) {
  Literal* const chosen =
      selection == Selection::kMaximal ? nullptr : Choose(terms, selection, literals);
  if (chosen == nullptr || selection == Selection::kUnlessUnique) {
    MarkMaximal(ordering, literals);
    if (chosen == nullptr || HasUniquePositive(literals)) return;
  }
  for (Literal& literal : literals) literal.eligible = &literal == chosen;
}

}  // namespace latchwork::pttp::saturation

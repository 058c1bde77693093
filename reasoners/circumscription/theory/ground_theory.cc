// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/theory/ground_theory.h"

#include <fmt/format.h>

namespace latchwork::circumscription {

std::string ToString(const GroundTheory& theory, Literal literal) {
  const std::string& name = theory.at(AtomOf(literal)).name;
  const std::string_view sign = literal < 0 ? "~ " : "";
  return name.empty() ? fmt::format("{}{}", sign, AtomOf(literal))
                      : fmt::format("{}{}", sign, name);
}

std::string ToString(const GroundTheory& theory, std::span<const Literal> clause) {
  if (clause.empty()) return "$false";
  std::string text;
  for (const Literal literal : clause) {
    if (!text.empty()) text += " | ";
    text += ToString(theory, literal);
  }
  return text;
}

}  // namespace latchwork::circumscription

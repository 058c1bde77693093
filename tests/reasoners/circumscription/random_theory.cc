// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reasoners/circumscription/random_theory.h"

namespace latchwork::circumscription {
namespace {

Literal RandomLiteral(Dice& dice, int atoms, int negative_of_ten) {
  const Literal atom = dice.Roll(atoms) + 1;
  return dice.Roll(10) < negative_of_ten ? -atom : atom;
}

Clause RandomClause(Dice& dice, int atoms, int style) {
  Clause clause;
  const int size = 1 + dice.Roll(4);
  for (int i = 0; i < size; ++i) {
    if (style == 0) clause.push_back(RandomLiteral(dice, atoms, 5));
    if (style == 1) clause.push_back(RandomLiteral(dice, atoms, i == 0 ? 0 : 10));
    if (style == 2) clause.push_back(RandomLiteral(dice, atoms, 2));
    if (style == 3) clause.push_back(RandomLiteral(dice, atoms, 6));
  }
  return clause;
}

}  // namespace

GroundTheory RandomTheory(Dice& dice, int most_atoms) {
  GroundTheory theory;
  const int atoms = 1 + dice.Roll(most_atoms);
  const int levels = 1 + dice.Roll(3);
  const int minimized_of_ten = 1 + dice.Roll(10);
  for (int i = 0; i < atoms; ++i) {
    AtomInfo info;
    if (dice.Roll(10) < minimized_of_ten) {
      info.role = Role::kMinimized;
      info.level = 1 + dice.Roll(levels);
    } else {
      info.role = dice.Roll(2) == 0 ? Role::kVarying : Role::kFixed;
    }
    theory.Add(info);
  }
  const int style = dice.Roll(4);
  const int clauses = dice.Roll(3 * atoms + 1);
  for (int i = 0; i < clauses; ++i) theory.clauses.push_back(RandomClause(dice, atoms, style));
  return theory;
}

std::vector<Literal> RandomLiterals(Dice& dice, const GroundTheory& theory, int most) {
  std::vector<Literal> literals;
  const int size = dice.Roll(most + 1);
  for (int i = 0; i < size; ++i) {
    literals.push_back(RandomLiteral(dice, static_cast<int>(theory.atoms.size()), 5));
  }
  return literals;
}

std::vector<Literal> RandomLatches(Dice& dice, const GroundTheory& theory) {
  std::vector<Literal> latches;
  const bool open = dice.Roll(3) == 0;
  for (std::size_t i = 0; i < theory.atoms.size(); ++i) {
    if (theory.atoms[i].role != Role::kFixed || (open && dice.Roll(2) == 0)) continue;
    const auto atom = static_cast<Atom>(i + 1);
    latches.push_back(dice.Roll(2) == 0 ? atom : -atom);
  }
  return latches;
}

}  // namespace latchwork::circumscription

// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reasoners/circumscription/random_layers.h"

#include <algorithm>

namespace latchwork::circumscription {
namespace {

Atom AnyAtom(Dice& dice, const GroundTheory& theory) {
  return dice.Roll(static_cast<int>(theory.atoms.size())) + 1;
}

AtomInfo AnyRole(Dice& dice) {
  const int roll = dice.Roll(10);
  if (roll == 0) return {Role::kFixed, 1, ""};
  if (roll <= 2) return {Role::kVarying, 1, ""};
  return {Role::kMinimized, 1 + dice.Roll(4) / 3, ""};
}

TheoryLayer RandomLayer(Dice& dice, int atoms) {
  TheoryLayer layer;
  for (int i = 0; i < atoms; ++i) layer.theory.Add(AnyRole(dice));
  const bool definite = dice.Roll(2) == 0;
  const int clauses = dice.Roll(2 * atoms);
  for (int i = 0; i < clauses; ++i) {
    Clause clause;
    const int size = 1 + dice.Roll(6) % 4;
    for (int k = 0; k < size; ++k) {
      const bool negated = definite ? k > 0 : dice.Roll(5) < 2;
      const Atom atom = AnyAtom(dice, layer.theory);
      clause.push_back(negated ? -atom : atom);
    }
    layer.theory.clauses.push_back(clause);
  }
  const int facts = dice.Roll(3);
  for (int i = 0; i < facts; ++i) {
    const Atom atom = AnyAtom(dice, layer.theory);
    layer.facts.push_back(!definite && dice.Roll(3) == 0 ? -atom : atom);
  }
  return layer;
}

bool IsDefiniteClause(std::span<const Literal> clause) {
  return std::count_if(clause.begin(), clause.end(), [](Literal literal) { return literal > 0; }) ==
         1;
}

}  // namespace

LayeredTheory RandomLayers(Dice& dice) {
  LayeredTheory theory;
  const int layers = 2 + dice.Roll(3);
  const int least = layers == 4 ? 2 : 3;
  const int most = layers == 2 ? 5 : layers == 3 ? 4 : 3;
  int left = 15;
  for (int i = 0; i < layers; ++i) {
    const int needed = (layers - 1 - i) * (least + 1);
    const int bridges = i == 0 || layers == 4 ? 1 : 1 + dice.Roll(2);
    const int room = left - needed - (i == 0 ? 0 : bridges);
    const int atoms = std::min(room, least + dice.Roll(most - least + 1));
    theory.layers.push_back(RandomLayer(dice, atoms));
    left -= atoms;
    if (i == 0) continue;
    left -= bridges;
    TheoryLayer& below = theory.layers[static_cast<std::size_t>(i) - 1];
    for (int k = 0; k < bridges; ++k) {
      below.bridges.push_back(
          {AnyAtom(dice, theory.layers.back().theory), AnyAtom(dice, below.theory)});
    }
  }
  return theory;
}

bool IsDefinite(const TheoryLayer& layer) {
  return std::all_of(layer.theory.clauses.begin(), layer.theory.clauses.end(),
                     [](const Clause& clause) { return IsDefiniteClause(clause); }) &&
         std::all_of(layer.facts.begin(), layer.facts.end(), [](Literal fact) { return fact > 0; });
}

std::vector<Clause> LayeredQueries(Dice& dice, const LayeredTheory& theory) {
  const GroundTheory& lowest = theory.layers.front().theory;
  std::vector<Clause> queries;
  for (Atom atom = 1; atom <= static_cast<Atom>(lowest.atoms.size()); ++atom) {
    queries.push_back({atom});
    queries.push_back({-atom});
  }
  for (int i = 0; i < 3; ++i) queries.push_back(RandomLiterals(dice, lowest, 3));
  return queries;
}

}  // namespace latchwork::circumscription

// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reasoners/circumscription/oracle.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <map>

namespace latchwork::circumscription {
namespace {

using World = Oracle::World;

/// Truth values of 64 worlds at once.
using Block = std::uint64_t;
constexpr std::array<Block, 6> kColumns = {0xAAAAAAAAAAAAAAAA, 0xCCCCCCCCCCCCCCCC,
                                           0xF0F0F0F0F0F0F0F0, 0xFF00FF00FF00FF00,
                                           0xFFFF0000FFFF0000, 0xFFFFFFFF00000000};

Block ColumnOf(Literal literal, World first_world) {
  const auto bit = static_cast<std::size_t>(AtomOf(literal)) - 1;
  const bool high = bit >= kColumns.size() && (first_world >> bit & 1U) != 0;
  const Block column = bit < kColumns.size() ? kColumns[bit] : high ? ~Block{0} : Block{0};
  return literal > 0 ? column : ~column;
}

Block ModelsIn(const std::vector<Clause>& clauses, World first_world) {
  Block models = ~Block{0};
  for (const Clause& clause : clauses) {
    Block satisfied = 0;
    for (const Literal literal : clause) satisfied |= ColumnOf(literal, first_world);
    models &= satisfied;
    if (models == 0) break;
  }
  return models;
}

}  // namespace

Oracle::Oracle(const GroundTheory& theory, std::span<const Literal> latches) {
  assert(theory.atoms.size() <= 16);
  std::map<int, World> levels;
  for (std::size_t i = 0; i < theory.atoms.size(); ++i) {
    const AtomInfo& atom = theory.atoms[i];
    if (atom.role == Role::kFixed) fixed_ |= World{1} << i;
    if (atom.role == Role::kMinimized) levels[atom.level] |= World{1} << i;
  }
  for (const auto& [level, atoms] : levels) levels_.push_back(atoms);
  std::vector<Clause> clauses = theory.clauses;
  for (const Literal latch : latches) clauses.push_back({latch});
  const World worlds = World{1} << theory.atoms.size();
  for (World first = 0; first < worlds; first += 64) {
    Block models = ModelsIn(clauses, first);
    if (worlds < 64) models &= (Block{1} << worlds) - 1;
    for (World i = 0; i < 64; ++i) {
      if ((models >> i & 1U) != 0) models_.push_back(first + i);
    }
  }
  FindMinimal();
}

bool Oracle::IsBelow(World lower, World upper) const {
  if (((lower ^ upper) & fixed_) != 0) return false;
  for (const World level : levels_) {
    const World here = lower & level;
    const World there = upper & level;
    if (here != there) return (here & ~there) == 0;
  }
  return false;
}

void Oracle::FindMinimal() {
  World ordered = fixed_;
  for (const World level : levels_) ordered |= level;
  std::vector<World> parts;
  for (const World model : models_) parts.push_back(model & ordered);
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  std::vector<World> lowest;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(lowest), [&](World part) {
    return std::none_of(parts.begin(), parts.end(),
                        [&](World other) { return IsBelow(other, part); });
  });
  std::copy_if(models_.begin(), models_.end(), std::back_inserter(minimal_), [&](World model) {
    return std::binary_search(lowest.begin(), lowest.end(), model & ordered);
  });
}

bool Oracle::EntailsAlways(std::span<const Literal> clause) const {
  return std::all_of(minimal_.begin(), minimal_.end(), [&](World world) {
    return std::any_of(clause.begin(), clause.end(),
                       [&](Literal literal) { return HoldsIn(world, literal); });
  });
}

bool Oracle::HoldsSomewhere(std::span<const Literal> conjunction) const {
  return std::any_of(minimal_.begin(), minimal_.end(), [&](World world) {
    return std::all_of(conjunction.begin(), conjunction.end(),
                       [&](Literal literal) { return HoldsIn(world, literal); });
  });
}

}  // namespace latchwork::circumscription

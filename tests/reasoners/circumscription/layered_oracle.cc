// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reasoners/circumscription/layered_oracle.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>

namespace latchwork::circumscription {
namespace {

/// The worlds of one block in which each of the first six atoms holds.
constexpr std::array<std::uint64_t, 6> kColumns = {0xAAAAAAAAAAAAAAAA, 0xCCCCCCCCCCCCCCCC,
                                                   0xF0F0F0F0F0F0F0F0, 0xFF00FF00FF00FF00,
                                                   0xFFFF0000FFFF0000, 0xFFFFFFFF00000000};

std::size_t BitOf(std::size_t atom) { return std::size_t{1} << (atom - kColumns.size()); }

}  // namespace

Worlds::Worlds(std::size_t atoms)
    : atoms_(atoms), blocks_(atoms > 6 ? std::size_t{1} << (atoms - 6) : 1, ~std::uint64_t{0}) {
  assert(atoms <= 15);
}

Worlds Worlds::Where(std::size_t atoms, std::size_t atom, bool holds) {
  Worlds worlds(atoms);
  for (std::size_t i = 0; i < worlds.blocks_.size(); ++i) {
    std::uint64_t column = 0;
    if (atom < kColumns.size()) {
      column = kColumns[atom];
    } else if ((i & BitOf(atom)) != 0) {
      column = ~column;
    }
    worlds.blocks_[i] = holds ? column : ~column;
  }
  return worlds;
}

Worlds& Worlds::operator&=(const Worlds& other) {
  for (std::size_t i = 0; i < blocks_.size(); ++i) blocks_[i] &= other.blocks_[i];
  return *this;
}

Worlds& Worlds::operator|=(const Worlds& other) {
  for (std::size_t i = 0; i < blocks_.size(); ++i) blocks_[i] |= other.blocks_[i];
  return *this;
}

void Worlds::Remove(const Worlds& other) {
  for (std::size_t i = 0; i < blocks_.size(); ++i) blocks_[i] &= ~other.blocks_[i];
}

bool Worlds::empty() const {
  return std::all_of(blocks_.begin(), blocks_.end(),
                     [](std::uint64_t block) { return block == 0; });
}

void Worlds::Forget(std::size_t atom) {
  Worlds lowered = *this;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (atom < kColumns.size()) {
      lowered.blocks_[i] = (blocks_[i] & kColumns[atom]) >> (std::size_t{1} << atom);
    } else {
      lowered.blocks_[i] = (i & BitOf(atom)) == 0 ? blocks_[i | BitOf(atom)] : 0;
    }
  }
  *this |= Raised(atom);
  *this |= lowered;
}

Worlds Worlds::Raised(std::size_t atom) const {
  Worlds raised = *this;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (atom < kColumns.size()) {
      raised.blocks_[i] = (blocks_[i] & ~kColumns[atom]) << (std::size_t{1} << atom);
    } else {
      raised.blocks_[i] = (i & BitOf(atom)) != 0 ? blocks_[i & ~BitOf(atom)] : 0;
    }
  }
  return raised;
}

std::size_t LayeredOracle::AtomCount(const LayeredTheory& theory) {
  std::size_t count = 0;
  for (const TheoryLayer& layer : theory.layers) {
    count += layer.theory.atoms.size() + layer.bridges.size();
  }
  return count;
}

LayeredOracle::LayeredOracle(const LayeredTheory& theory)
    : atoms_(AtomCount(theory)), models_(atoms_) {
  std::size_t next = 0;
  for (const TheoryLayer& layer : theory.layers) {
    first_.push_back(next);
    next += layer.theory.atoms.size();
    first_abnormal_.push_back(next);
    next += layer.bridges.size();
  }
  for (std::size_t i = 0; i < theory.layers.size(); ++i) models_ &= Circumscribed(theory, i);
}

Worlds LayeredOracle::Satisfying(std::size_t layer, std::span<const Literal> clause) const {
  Worlds worlds(atoms_);
  worlds.Remove(Worlds(atoms_));
  for (const Literal literal : clause) {
    worlds |= Worlds::Where(atoms_, Place(layer, AtomOf(literal)), literal > 0);
  }
  return worlds;
}

Worlds LayeredOracle::Circumscribed(const LayeredTheory& theory, std::size_t layer) const {
  const TheoryLayer& source = theory.layers[layer];
  Worlds models(atoms_);
  for (const Clause& clause : source.theory.clauses) models &= Satisfying(layer, clause);
  for (const Literal fact : source.facts) models &= Satisfying(layer, {&fact, 1});
  std::map<int, std::vector<std::size_t>> levels;  // Level 0: the ab.
  std::vector<std::size_t> later;                  // May vary: at first all but the fixed atoms.
  for (std::size_t i = 0; i < source.bridges.size(); ++i) {
    const Bridge& bridge = source.bridges[i];
    Worlds kept = Worlds::Where(atoms_, Place(layer + 1, bridge.goal), false);
    kept |= Worlds::Where(atoms_, first_abnormal_[layer] + i, true);
    kept |= Worlds::Where(atoms_, Place(layer, bridge.latch), true);
    models &= kept;
    levels[0].push_back(first_abnormal_[layer] + i);
  }
  for (std::size_t i = 0; i < source.theory.atoms.size(); ++i) {
    const AtomInfo& atom = source.theory.atoms[i];
    if (atom.role == Role::kMinimized) levels[atom.level].push_back(first_[layer] + i);
    if (atom.role == Role::kVarying) later.push_back(first_[layer] + i);
  }
  for (auto level = levels.begin(); level != levels.end(); ++level) {
    Worlds above = models;
    for (const std::size_t atom : later) above.Forget(atom);
    for (auto next = std::next(level); next != levels.end(); ++next) {
      for (const std::size_t atom : next->second) above.Forget(atom);
    }
    for (const std::size_t atom : level->second) above |= above.Raised(atom);
    for (const std::size_t atom : level->second) models.Remove(above.Raised(atom));
  }
  return models;
}

bool LayeredOracle::Entails(std::size_t layer, std::span<const Literal> clause) const {
  Worlds rest = models_;
  rest.Remove(Satisfying(layer, clause));
  return rest.empty();
}

}  // namespace latchwork::circumscription

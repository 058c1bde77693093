// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_THEORY_GROUND_THEORY_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_THEORY_GROUND_THEORY_H_

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace latchwork::circumscription {

/// Atoms are numbered from 1. A literal is an atom, or its negative for the negation.
using Atom = std::int32_t;
using Literal = std::int32_t;
using Clause = std::vector<Literal>;

constexpr Atom AtomOf(Literal literal) { return literal < 0 ? -literal : literal; }

/// What circumscription does with an atom: P, Z and Q of CIRC[T; P; Z].
enum class Role : std::uint8_t { kMinimized, kVarying, kFixed };

struct AtomInfo {
  Role role = Role::kVarying;
  int level = 1;     ///< Of minimized atoms: 1 is minimized first. All on 1: parallel.
  std::string name;  ///< For people; may be empty.
};

/// A finite set of ground clauses, and what is to be done with each atom.
struct GroundTheory {
  std::vector<AtomInfo> atoms;  ///< Atom a stands at a - 1.
  std::vector<Clause> clauses;

  Atom Add(AtomInfo info) {
    atoms.push_back(std::move(info));
    return static_cast<Atom>(atoms.size());
  }
  const AtomInfo& at(Atom atom) const { return atoms[static_cast<std::size_t>(atom) - 1]; }
};

/// `object(3)`, `~ object(3)`; atoms without a name print as their number.
std::string ToString(const GroundTheory& theory, Literal literal);
/// Literals joined by ` | `; `$false` where there are none.
std::string ToString(const GroundTheory& theory, std::span<const Literal> clause);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_THEORY_GROUND_THEORY_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_CLAUSE_H_
#define LATCHWORK_LOGIC_CLAUSE_H_

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/diagnostic.h"

namespace latchwork::logic {

/// An atom or its negation.
struct Literal {
  bool positive = true;
  Atom atom;
  friend bool operator==(const Literal&, const Literal&) = default;
  friend std::strong_ordering operator<=>(const Literal& a, const Literal& b) {
    if (a.positive != b.positive) return a.positive <=> b.positive;
    return a.atom <=> b.atom;
  }
};

/// The part that a formula plays for a prover. TPTP's roles fold into these three: axiom,
/// hypothesis, definition, assumption, lemma, theorem, corollary and plain are axioms.
enum class Role : std::uint8_t { kAxiom, kConjecture, kNegatedConjecture };

/// A disjunction of literals, its variables 0 .. variable_names.size()-1 universally quantified. No
/// literals: falsity.
struct Clause {
  std::string name;  ///< Of the annotated formula that it stems from.
  Role role = Role::kAxiom;
  std::vector<Literal> literals;
  std::vector<std::string> variable_names;
  SourcePlace place;
};

std::string ToString(const Literal& literal, std::span<const std::string> variable_names = {});
/// The disjunction alone: `p(X) | ~ q(X)`, or `$false`.
std::string ToString(const Clause& clause);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_CLAUSE_H_

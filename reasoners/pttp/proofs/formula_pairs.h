// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_FORMULA_PAIRS_H_
#define LATCHWORK_PTTP_FORMULA_PAIRS_H_

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "latchwork/logic/formula.h"

namespace latchwork::pttp {

/// A part of a formula, and what a normal form of the formula says in its place.
struct FormulaPair {
  const logic::Formula* said = nullptr;  ///< No negation.
  bool positive = true;                  ///< Else the normal form says its negation.
  const logic::Formula* normal = nullptr;
  std::vector<std::size_t> parts;  ///< Indices of pairs; of a name: the body of its definition.
  std::size_t size = 1;            ///< Literals and quantifiers.
  std::size_t depth = 0;           ///< Blocks of like quantifiers within each other.
  bool is_name = false;            ///< `normal` is an atom that is defined.
};

/// The body of a defined atom; nothing for other atoms.
using BodyOf = std::function<const logic::Formula*(const logic::Atom&)>;

/// A formula and its normal form part by part, parts before wholes, where the normal form differs
/// by negations and nesting of like connectives alone. Points into both.
std::optional<std::vector<FormulaPair>> PairFormulas(const logic::Formula& said, bool positive,
                                                     const logic::Formula& normal,
                                                     const BodyOf& body_of);

/// As the pair's formula says it: negated where it is not positive.
logic::Formula Said(const FormulaPair& pair);

/// In ascending order.
std::vector<logic::Variable> FreeVariables(const logic::Formula& formula);

/// The formula with parts, given by their addresses, replaced.
using Replacements = std::map<const logic::Formula*, logic::Formula>;
logic::Formula Replaced(const logic::Formula& formula, const Replacements& by);

/// Below a quantifier over the variables that are free in it.
logic::Formula Closed(logic::Formula formula);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_FORMULA_PAIRS_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_CHECK_PROOF_NORMAL_FORM_H_
#define LATCHWORK_APPS_CHECK_PROOF_NORMAL_FORM_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/formula.h"

namespace latchwork::check_proof {

/// A formula in negation normal form. Depth and size are bounded where it is made, so what works on
/// it may recurse.
struct Tree {
  enum class Kind : std::uint8_t { kTrue, kFalse, kLiteral, kAnd, kOr, kForall, kExists };
  Kind kind = Kind::kTrue;
  logic::Literal literal;                  ///< kLiteral only.
  std::vector<Tree> children;              ///< One below a quantifier.
  std::vector<logic::Variable> variables;  ///< Quantifiers only.
};

/// What a defined predicate stands for: the arguments are distinct variables, free in the body.
struct Definition {
  std::vector<logic::Variable> parameters;
  logic::Formula body;
};
using Definitions = std::map<logic::PredicateName, Definition>;

/// The formula, or its negation; defined atoms are replaced by what they stand for. Bound variables
/// get numbers of their own from `next_variable` on. Nothing when it is too large or too deep.
class Normalizer {
 public:
  explicit Normalizer(const Definitions& definitions) : definitions_(definitions) {}
  std::optional<Tree> Normalize(const logic::Formula& formula, bool positive);

 private:
  using Renaming = std::map<logic::Variable, logic::Term>;
  bool Build(const logic::Formula& formula, bool positive, const Renaming& renaming, Tree& tree);
  bool BuildAtom(const logic::Atom& atom, bool positive, const Renaming& renaming, Tree& tree);
  bool BuildJunction(Tree::Kind kind, const logic::Formula& formula, bool positive,
                     const Renaming& renaming, Tree& tree);
  bool BuildEquivalence(const logic::Formula& formula, bool positive, const Renaming& renaming,
                        Tree& tree);
  bool BuildQuantifier(const logic::Formula& formula, bool positive, const Renaming& renaming,
                       Tree& tree);

  const Definitions& definitions_;
  logic::Variable next_variable_ = 0;
  std::size_t size_ = 0;
  std::size_t depth_ = 0;
};

/// Truth values go, junctions within like junctions and quantifiers within like quantifiers become
/// one, and quantifiers move inwards as far as they can without being copied.
void MoveQuantifiersInwards(Tree& tree);

/// What a formula says piece by piece: the conjuncts below its universal quantifiers, however these
/// are nested, each below those that bind something in it, with quantifiers moved inwards.
std::vector<Tree> ConjunctsOf(const Tree& tree);

/// The same of a conjunct that is a disjunction of literals and one conjunction, which is
/// distributed; of others, the conjunct.
std::vector<Tree> PartsOf(const Tree& conjunct);

/// Equal but for the numbers of bound variables and the order within blocks of quantifiers,
/// conjunctions and disjunctions. Nothing when it takes too long to say.
std::optional<bool> IsVariant(const Tree& a, const Tree& b);

/// The variables that occur free.
std::vector<logic::Variable> FreeVariables(const Tree& tree);

/// Whether terms are so shallow that what works on them may recurse.
bool IsShallow(const logic::Atom& atom);

/// Replaces variables in a term.
logic::Term Substitute(const logic::Term& term, const std::map<logic::Variable, logic::Term>& by);
logic::Atom Substitute(const logic::Atom& atom, const std::map<logic::Variable, logic::Term>& by);

}  // namespace latchwork::check_proof

#endif  // LATCHWORK_APPS_CHECK_PROOF_NORMAL_FORM_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_FORMULA_H_
#define LATCHWORK_LOGIC_FORMULA_H_

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/clause.h"

namespace latchwork::logic {

/// A first-order formula as an immutable, shared value. Every quantifier of one formula binds
/// variables of its own numbers, so no renaming is needed to move quantifiers. Nesting may be deep:
/// nothing here recurses.
class Formula {
 public:
  enum class Kind : std::uint8_t {
    kTrue,
    kFalse,
    kAtom,
    kNot,         ///< One child.
    kAnd,         ///< Two or more children.
    kOr,          ///< Two or more children.
    kImplies,     ///< Two children: `a => b`; the reader turns `<=` round.
    kEquivalent,  ///< Two children; the reader writes `<~>` as ~(a <=> b), `~|` and `~&` as
                  ///< negations.
    kForall,      ///< One child.
    kExists,      ///< One child.
  };

  Formula() = default;  ///< $true
  Formula(const Formula&);
  Formula(Formula&&) noexcept;
  Formula& operator=(const Formula&);
  Formula& operator=(Formula&&) noexcept;
  ~Formula();

  static Formula True();
  static Formula False();
  static Formula Of(Atom atom);
  static Formula Not(Formula child);
  static Formula And(std::vector<Formula> children);
  static Formula Or(std::vector<Formula> children);
  static Formula Implies(Formula premise, Formula conclusion);
  static Formula Equivalent(Formula a, Formula b);
  static Formula Forall(std::vector<Variable> variables, Formula child);
  static Formula Exists(std::vector<Variable> variables, Formula child);

  /// The same connective or quantifier of other children, as many; an atom or constant has none.
  Formula With(std::vector<Formula> children) const;

  Kind kind() const;
  const Atom& atom() const;                     ///< kAtom only.
  std::span<const Formula> children() const;    ///< Empty for atoms and constants.
  std::span<const Variable> variables() const;  ///< Quantifiers only.

 private:
  struct Node;
  explicit Formula(Node* node) : node_(node) {}
  void Release() noexcept;

  Node* node_ = nullptr;  ///< Null: $true.
};

/// A formula of a TPTP file: `fof(name, role, formula).` or `cnf(...)`, whose variables are then
/// closed universally.
struct AnnotatedFormula {
  std::string name;
  Role role = Role::kAxiom;
  Formula formula;
  std::vector<std::string> variable_names;  ///< Indexed by Variable.
  bool is_clause = false;                   ///< Written as cnf(...).
  SourcePlace place;
};

std::string ToString(const Formula& formula, std::span<const std::string> variable_names = {});

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_FORMULA_H_

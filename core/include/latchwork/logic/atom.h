// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_ATOM_H_
#define LATCHWORK_LOGIC_ATOM_H_

#include <array>
#include <compare>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "latchwork/logic/term.h"

namespace latchwork::logic {

/// A predicate applied to terms. Equality is the predicate `=`. Up to four arguments live in the
/// atom itself, so that the facts of a control loop need no heap memory.
class Atom {
 public:
  static constexpr std::size_t kInlineArguments = 4;

  Atom() = default;
  explicit Atom(Symbol predicate) : predicate_(predicate) {}
  Atom(Symbol predicate, std::span<const Term> arguments);
  Atom(Symbol predicate, std::initializer_list<Term> arguments)
      : Atom(predicate, std::span<const Term>(arguments.begin(), arguments.size())) {}

  Symbol predicate() const { return predicate_; }
  std::size_t arity() const { return arity_; }
  std::span<const Term> arguments() const {
    return arity_ <= kInlineArguments ? std::span<const Term>(inline_.data(), arity_)
                                      : std::span<const Term>(more_);
  }
  const Term& argument(std::size_t index) const { return arguments()[index]; }
  bool is_ground() const;

  friend bool operator==(const Atom& a, const Atom& b);
  friend std::strong_ordering operator<=>(const Atom& a, const Atom& b);

 private:
  Symbol predicate_;
  std::size_t arity_ = 0;
  std::array<Term, kInlineArguments> inline_;
  std::vector<Term> more_;  ///< All arguments, when there are more than fit inline.
};

/// A ground atom. Everything that flows between the parts of an agent is a fact.
using Fact = Atom;

/// TPTP syntax: `p(a, 1)`, `a = b`.
std::string ToString(const Atom& atom, std::span<const std::string> variable_names = {});

/// p/2: what a contract, an index or a policy speaks about.
struct PredicateName {
  Symbol symbol;
  std::size_t arity = 0;
  friend auto operator<=>(const PredicateName&, const PredicateName&) = default;
};

std::string ToString(const PredicateName& name);

inline PredicateName NameOf(const Atom& atom) { return {atom.predicate(), atom.arity()}; }

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_ATOM_H_

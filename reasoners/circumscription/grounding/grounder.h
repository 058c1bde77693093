// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_GROUNDING_GROUNDER_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_GROUNDING_GROUNDER_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "latchwork/logic/clause.h"
#include "reasoners/circumscription/theory/ground_theory.h"

namespace latchwork::circumscription {

/// What is to be done with each predicate; those not named vary.
struct PredicateRoles {
  std::map<logic::PredicateName, int> minimized;  ///< With the priority level, 1 is first.
  std::map<logic::PredicateName, int> fixed;      ///< The value is of no account.
};

/// Grounds function-free clauses over a finite domain of constants, which are all different and all
/// there is. By need: an instance in which a negated minimized atom can never be true is left out,
/// since such an atom is false in every minimal model. The instances are found as in semi-naive
/// evaluation of rules, each one once.
class Grounder {
 public:
  Grounder(const PredicateRoles& roles, const std::vector<logic::Term>& domain,
           std::size_t max_steps)
      : roles_(roles), domain_(domain), steps_left_(max_steps) {}

  /// False: more than `max_steps` steps would be needed.
  bool Ground(const std::vector<logic::Clause>& clauses);

  const GroundTheory& theory() const { return theory_; }
  /// Nothing: the atom is false in all minimal models, or nothing is said about it.
  std::optional<Atom> Find(const logic::Atom& atom) const;

 private:
  /// The atoms of a minimized predicate that may be true, in the order in which they were found.
  struct Relation {
    std::vector<logic::Atom> atoms;
    std::size_t old = 0;  ///< Seen before the present round.
    std::size_t end = 0;  ///< Seen in it.
  };
  struct Rule {
    const logic::Clause* clause = nullptr;
    std::vector<const logic::Literal*> joins;  ///< Negated, of minimized predicates.
  };
  using Bindings = std::vector<std::optional<logic::Term>>;

  void AddRule(const logic::Clause& clause);
  void Join(const Rule& rule, std::size_t next, std::size_t newest);
  void Match(const Rule& rule, std::size_t next, std::size_t newest, const logic::Atom& fact);
  void Enumerate(const Rule& rule, std::size_t variable);
  void Emit(const Rule& rule);
  Literal Number(const logic::Literal& literal);
  logic::Atom Instance(const logic::Atom& atom) const;
  bool Advance();
  bool Step() {
    if (steps_left_ > 0) --steps_left_;
    return steps_left_ > 0;
  }

  const PredicateRoles& roles_;
  const std::vector<logic::Term>& domain_;
  std::size_t steps_left_;
  std::vector<Rule> rules_;
  std::map<logic::PredicateName, Relation> relations_;
  std::map<logic::Atom, Atom> numbers_;
  Bindings bindings_;
  GroundTheory theory_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_GROUNDING_GROUNDER_H_

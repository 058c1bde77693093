// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_GROUND_STORE_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_GROUND_STORE_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "reasoners/circumscription/evaluation/fact_table.h"
#include "reasoners/circumscription/rules/relations.h"
#include "reasoners/circumscription/theory/ground_theory.h"

namespace latchwork::circumscription {

/// The ground theory that cycles have in common: instances of clauses, each once, over numbered
/// atoms. What is given in a cycle (facts of latches, answers of attachments) stands in it as a
/// fixed atom, so that the theory need not change when only that does. Instances that an earlier
/// cycle found stay: they are true, and say nothing where their facts are gone.
class GroundStore {
 public:
  struct Place {
    std::size_t relation = 0;
    std::uint32_t row = 0;  ///< In the table of the relation's atoms.
    bool is_given = false;  ///< The atom says that the fact is given.
  };

  explicit GroundStore(const Relations& relations) : relations_(relations) {}

  Atom AtomOf(std::size_t relation, std::span<const Value> cells);
  /// 0: there is no such atom.
  Atom Find(std::size_t relation, std::span<const Value> cells) const;
  void Add(std::size_t source, std::span<const Literal> clause);
  /// Starts the list of what is given.
  void BeginGiven() { given_now_.clear(); }
  void Give(std::size_t relation, std::span<const Value> cells);
  /// The value of every fixed atom that is known: what is given holds, what was given in an earlier
  /// cycle only does not; atoms of fixed predicates are known only where they are given.
  std::vector<Literal> Latches() const;

  const GroundTheory& theory() const { return theory_; }
  const Place& place(Atom atom) const { return places_[static_cast<std::size_t>(atom) - 1]; }
  std::span<const Value> Cells(Atom atom) const;
  /// The clause that an instance is of; kNoIndex: it says that what is given holds.
  std::size_t source(std::size_t clause) const { return sources_[clause]; }
  std::size_t size() const { return theory_.clauses.size(); }
  void Clear();

 private:
  struct Atoms {
    FactTable table;
    std::vector<Atom> atoms;   ///< By row.
    std::vector<Atom> givens;  ///< By row; 0: never given.
  };
  Atoms& Of(std::size_t relation);
  std::uint32_t RowOf(std::size_t relation, std::span<const Value> cells);
  Atom NewAtom(std::size_t relation, std::uint32_t row, Role role, bool is_given);
  Role RoleOf(std::size_t relation) const;

  const Relations& relations_;
  GroundTheory theory_;
  std::vector<std::unique_ptr<Atoms>> atoms_;  ///< By relation.
  std::vector<Place> places_;                  ///< By atom.
  std::vector<std::size_t> sources_;           ///< By clause.
  std::vector<Atom> given_now_;
  RowTable clauses_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_GROUND_STORE_H_

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/exact/ground_store.h"

#include <algorithm>
#include <climits>

namespace latchwork::circumscription {

GroundStore::Atoms& GroundStore::Of(std::size_t relation) {
  if (atoms_.size() <= relation) atoms_.resize(relation + 1);
  if (!atoms_[relation]) {
    atoms_[relation] =
        std::make_unique<Atoms>(Atoms{FactTable(relations_[relation].name.arity, {}), {}, {}});
  }
  return *atoms_[relation];
}

std::uint32_t GroundStore::RowOf(std::size_t relation, std::span<const Value> cells) {
  Atoms& atoms = Of(relation);
  const std::uint32_t row = atoms.table.Insert(cells, {});
  atoms.atoms.resize(atoms.table.size(), 0);
  atoms.givens.resize(atoms.table.size(), 0);
  return row;
}

/// What varies and is concluded by some clause is minimized last: this takes no conclusion away and
/// adds none, and tells what is open from what nothing speaks for.
Role GroundStore::RoleOf(std::size_t relation) const {
  const RelationInfo& info = relations_[relation];
  if (info.is_fixed) return Role::kFixed;
  return info.level > 0 || info.is_concluded ? Role::kMinimized : Role::kFixed;
}

Atom GroundStore::NewAtom(std::size_t relation, std::uint32_t row, Role role, bool is_given) {
  const int level = relations_[relation].level;
  places_.push_back({relation, row, is_given});
  return theory_.Add({role, level > 0 ? level : INT_MAX, {}});
}

Atom GroundStore::AtomOf(std::size_t relation, std::span<const Value> cells) {
  const std::uint32_t row = RowOf(relation, cells);
  Atom& atom = Of(relation).atoms[row];
  if (atom == 0) atom = NewAtom(relation, row, RoleOf(relation), false);
  return atom;
}

Atom GroundStore::Find(std::size_t relation, std::span<const Value> cells) const {
  if (relation >= atoms_.size() || !atoms_[relation]) return 0;
  const std::uint32_t row = atoms_[relation]->table.Find(cells);
  return row == FactTable::kNone ? 0 : atoms_[relation]->atoms[row];
}

void GroundStore::Add(std::size_t source, std::span<const Literal> clause) {
  std::uint64_t hash = source;
  for (const Literal literal : clause) hash = Mix(hash, static_cast<std::uint64_t>(literal));
  const auto same = [&](std::uint32_t row) {
    return sources_[row] == source &&
           std::equal(clause.begin(), clause.end(), theory_.clauses[row].begin(),
                      theory_.clauses[row].end());
  };
  if (clauses_.Find(hash, same) != RowTable::kNone) return;
  clauses_.Insert(hash, static_cast<std::uint32_t>(sources_.size()));
  sources_.push_back(source);
  theory_.clauses.emplace_back(clause.begin(), clause.end());
}

void GroundStore::Give(std::size_t relation, std::span<const Value> cells) {
  const std::uint32_t row = RowOf(relation, cells);
  const Atom atom = AtomOf(relation, cells);
  Atom& given = Of(relation).givens[row];
  if (given == 0) {
    const bool is_itself = theory_.at(atom).role == Role::kFixed;
    given = is_itself ? atom : NewAtom(relation, row, Role::kFixed, true);
    if (!is_itself) Add(kNoIndex, std::vector<Literal>{-given, atom});
  }
  given_now_.push_back(given);
}

std::vector<Literal> GroundStore::Latches() const {
  std::vector<Atom> now = given_now_;
  std::sort(now.begin(), now.end());
  now.erase(std::unique(now.begin(), now.end()), now.end());
  std::vector<Literal> latches;
  for (std::size_t i = 0; i < theory_.atoms.size(); ++i) {
    const auto atom = static_cast<Atom>(i + 1);
    if (theory_.atoms[i].role != Role::kFixed) continue;
    const bool holds = std::binary_search(now.begin(), now.end(), atom);
    const bool is_open = relations_[places_[i].relation].is_fixed && !places_[i].is_given;
    if (holds || !is_open) latches.push_back(holds ? atom : -atom);
  }
  return latches;
}

std::span<const Value> GroundStore::Cells(Atom atom) const {
  const Place& where = place(atom);
  return atoms_[where.relation]->table.Row(where.row);
}

void GroundStore::Clear() {
  theory_ = {};
  atoms_.clear();
  places_.clear();
  sources_.clear();
  given_now_.clear();
  clauses_.Clear();
}

}  // namespace latchwork::circumscription

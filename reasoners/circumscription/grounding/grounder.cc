// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/grounding/grounder.h"

#include <algorithm>

namespace latchwork::circumscription {
namespace {

using logic::Term;

bool IsEquality(const logic::Atom& atom) {
  return atom.predicate().name() == "=" && atom.arity() == 2;
}

}  // namespace

bool Grounder::Ground(const std::vector<logic::Clause>& clauses) {
  for (const auto& [name, level] : roles_.minimized) relations_[name] = {};
  for (const logic::Clause& clause : clauses) AddRule(clause);
  for (const Rule& rule : rules_) {
    if (rule.joins.empty()) Join(rule, 0, 0);
  }
  while (steps_left_ > 0 && Advance()) {
    for (const Rule& rule : rules_) {
      for (std::size_t newest = 0; newest < rule.joins.size(); ++newest) Join(rule, 0, newest);
    }
  }
  return steps_left_ > 0;
}

void Grounder::AddRule(const logic::Clause& clause) {
  Rule rule{&clause, {}};
  for (const logic::Literal& literal : clause.literals) {
    if (!literal.positive && relations_.contains(NameOf(literal.atom))) {
      rule.joins.push_back(&literal);
    }
  }
  rules_.push_back(std::move(rule));
}

/// What was new is old now, what was found since is new; false: nothing was.
bool Grounder::Advance() {
  bool found = false;
  for (auto& [name, relation] : relations_) {
    relation.old = relation.end;
    relation.end = relation.atoms.size();
    found = found || relation.end > relation.old;
  }
  return found;
}

/// Of the join literals the one at `newest` takes new atoms, those before it old ones and those
/// after it both, so that no instance comes twice.
void Grounder::Join(const Rule& rule, std::size_t next, std::size_t newest) {
  if (next == 0) bindings_.assign(rule.clause->variable_names.size(), std::nullopt);
  if (next == rule.joins.size()) return Enumerate(rule, 0);
  const Relation& relation = relations_.find(NameOf(rule.joins[next]->atom))->second;
  const std::size_t begin = next == newest ? relation.old : 0;
  const std::size_t end = next < newest ? relation.old : relation.end;
  for (std::size_t i = begin; i < end && Step(); ++i) {
    Match(rule, next, newest, logic::Atom(relation.atoms[i]));
  }
}

void Grounder::Match(const Rule& rule, std::size_t next, std::size_t newest,
                     const logic::Atom& fact) {
  const logic::Atom& pattern = rule.joins[next]->atom;
  std::vector<logic::Variable> bound;
  bool matches = true;
  for (std::size_t i = 0; i < pattern.arity() && matches; ++i) {
    const Term& argument = pattern.argument(i);
    if (!argument.is_variable()) {
      matches = argument == fact.argument(i);
    } else if (std::optional<Term>& value = bindings_[argument.variable()]; value) {
      matches = *value == fact.argument(i);
    } else {
      value = fact.argument(i);
      bound.push_back(argument.variable());
    }
  }
  if (matches) Join(rule, next + 1, newest);
  for (const logic::Variable variable : bound) bindings_[variable].reset();
}

/// Variables that no join bound take every value.
void Grounder::Enumerate(const Rule& rule, std::size_t variable) {
  while (variable < bindings_.size() && bindings_[variable]) ++variable;
  if (variable == bindings_.size()) return Emit(rule);
  for (const Term& value : domain_) {
    if (!Step()) break;
    bindings_[variable] = value;
    Enumerate(rule, variable + 1);
  }
  bindings_[variable].reset();
}

void Grounder::Emit(const Rule& rule) {
  Clause clause;
  for (const logic::Literal& literal : rule.clause->literals) {
    if (!IsEquality(literal.atom)) continue;
    const logic::Atom instance = Instance(literal.atom);
    if ((instance.argument(0) == instance.argument(1)) == literal.positive) return;
  }
  for (const logic::Literal& literal : rule.clause->literals) {
    if (!IsEquality(literal.atom)) clause.push_back(Number(literal));
  }
  theory_.clauses.push_back(std::move(clause));
}

logic::Atom Grounder::Instance(const logic::Atom& atom) const {
  std::vector<Term> arguments;
  for (const Term& argument : atom.arguments()) {
    arguments.push_back(argument.is_variable() ? *bindings_[argument.variable()] : argument);
  }
  return {atom.predicate(), arguments};
}

Literal Grounder::Number(const logic::Literal& literal) {
  const logic::Atom instance = Instance(literal.atom);
  const auto [place, is_new] = numbers_.try_emplace(instance, 0);
  if (is_new) {
    const logic::PredicateName name = NameOf(instance);
    const auto level = roles_.minimized.find(name);
    AtomInfo info{Role::kVarying, 1, ToString(instance)};
    if (level != roles_.minimized.end()) {
      info.role = Role::kMinimized;
      info.level = level->second;
      relations_.find(name)->second.atoms.push_back(instance);
    } else if (roles_.fixed.contains(name)) {
      info.role = Role::kFixed;
    }
    place->second = theory_.Add(std::move(info));
  }
  return literal.positive ? place->second : -place->second;
}

std::optional<Atom> Grounder::Find(const logic::Atom& atom) const {
  const auto place = numbers_.find(atom);
  if (place == numbers_.end()) return std::nullopt;
  return place->second;
}

}  // namespace latchwork::circumscription

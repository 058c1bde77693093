// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/instances.h"

#include <algorithm>

namespace latchwork::pttp {
namespace {

using logic::Atom;
using logic::Term;

constexpr std::size_t kMostVisits = 1000;

std::uint32_t VariableOf(TermCopy term) { return term.base + term.term->variable(); }

/// Whether two terms that are no variables begin alike.
bool SameHeads(const Term& a, const Term& b) {
  if (a.kind() != b.kind()) return false;
  if (a.kind() != Term::Kind::kCompound) return a == b;
  return a.symbol() == b.symbol() && a.arguments().size() == b.arguments().size();
}

}  // namespace

std::uint32_t Instances::Copy(std::size_t variables) {
  const auto base = static_cast<std::uint32_t>(values_.size());
  values_.resize(values_.size() + variables);
  return base;
}

void Instances::UndoTo(const Mark& mark) {
  for (; trail_.size() > mark.trail; trail_.pop_back()) values_[trail_.back()] = {};
  values_.resize(mark.variables);
}

TermCopy Instances::Resolve(TermCopy term) const {
  while (term.term->is_variable()) {
    const TermCopy next = values_[VariableOf(term)];
    if (next.term == nullptr) return term;
    term = next;
  }
  return term;
}

bool Instances::Occurs(std::uint32_t variable, TermCopy term) const {
  std::vector<TermCopy> visits{term};
  for (std::size_t count = 0; !visits.empty(); ++count) {
    ++work_;
    if (count > kMostVisits) return true;
    const TermCopy current = Resolve(visits.back());
    visits.pop_back();
    if (current.term->is_variable()) {
      if (VariableOf(current) == variable) return true;
      continue;
    }
    for (const Term& argument : current.term->arguments()) {
      visits.push_back({&argument, current.base});
    }
  }
  return false;
}

bool Instances::Bind(TermCopy variable, TermCopy value) {
  const std::uint32_t number = VariableOf(variable);
  if (Occurs(number, value)) return false;
  values_[number] = value;
  trail_.push_back(number);
  return true;
}

bool Instances::Unify(TermCopy a, TermCopy b) {
  std::vector<std::pair<TermCopy, TermCopy>> pairs{{a, b}};
  for (std::size_t count = 0; !pairs.empty(); ++count) {
    ++work_;
    if (count > kMostVisits) return false;
    const TermCopy left = Resolve(pairs.back().first);
    const TermCopy right = Resolve(pairs.back().second);
    pairs.pop_back();
    if (left.term->is_variable()) {
      const bool same = right.term->is_variable() && VariableOf(left) == VariableOf(right);
      if (!same && !Bind(left, right)) return false;
    } else if (right.term->is_variable()) {
      if (!Bind(right, left)) return false;
    } else {
      if (!SameHeads(*left.term, *right.term)) return false;
      for (std::size_t i = left.term->arguments().size(); i > 0; --i) {
        pairs.push_back({{&left.term->arguments()[i - 1], left.base},
                         {&right.term->arguments()[i - 1], right.base}});
      }
    }
  }
  return true;
}

bool Instances::Unify(const Atom& a, std::uint32_t base_a, const Atom& b, std::uint32_t base_b) {
  ++work_;
  if (a.predicate() != b.predicate() || a.arity() != b.arity()) return false;
  for (std::size_t i = 0; i < a.arity(); ++i) {
    if (!Unify({&a.argument(i), base_a}, {&b.argument(i), base_b})) return false;
  }
  return true;
}

bool Instances::Identical(const Atom& a, std::uint32_t base_a, const Atom& b,
                          std::uint32_t base_b) const {
  ++work_;
  if (a.predicate() != b.predicate() || a.arity() != b.arity()) return false;
  std::vector<std::pair<TermCopy, TermCopy>> pairs;
  for (std::size_t i = 0; i < a.arity(); ++i) {
    pairs.push_back({{&a.argument(i), base_a}, {&b.argument(i), base_b}});
  }
  for (std::size_t count = 0; !pairs.empty(); ++count) {
    ++work_;
    const TermCopy left = Resolve(pairs.back().first);
    const TermCopy right = Resolve(pairs.back().second);
    pairs.pop_back();
    if (count > kMostVisits || left.term->is_variable() != right.term->is_variable()) return false;
    if (left.term->is_variable()) {
      if (VariableOf(left) != VariableOf(right)) return false;
      continue;
    }
    if (!SameHeads(*left.term, *right.term)) return false;
    for (std::size_t i = 0; i < left.term->arguments().size(); ++i) {
      pairs.push_back(
          {{&left.term->arguments()[i], left.base}, {&right.term->arguments()[i], right.base}});
    }
  }
  return true;
}

std::optional<Term> Instances::Export(TermCopy term, Numbers& numbers) const {
  struct Pending {
    TermCopy copy;
    std::vector<Term> arguments;
  };
  std::vector<Pending> stack{{Resolve(term), {}}};
  for (std::size_t count = 0; count <= kMostVisits; ++count) {
    ++work_;
    Pending& top = stack.back();
    const Term& current = *top.copy.term;
    if (top.arguments.size() < current.arguments().size()) {
      const Term& next = current.arguments()[top.arguments.size()];
      stack.push_back({Resolve({&next, top.copy.base}), {}});
      continue;
    }
    Term made = current;
    if (current.is_variable()) {
      const auto next = static_cast<logic::Variable>(numbers.size());
      made = Term::Var(numbers.try_emplace(VariableOf(top.copy), next).first->second);
    } else if (!current.arguments().empty()) {
      made = Term::Compound(current.symbol(), std::move(top.arguments));
    }
    stack.pop_back();
    if (stack.empty()) return made;
    stack.back().arguments.push_back(std::move(made));
  }
  return std::nullopt;
}

std::optional<Atom> Instances::Export(const Atom& atom, std::uint32_t base,
                                      Numbers& numbers) const {
  std::vector<Term> arguments;
  for (const Term& argument : atom.arguments()) {
    auto made = Export({&argument, base}, numbers);
    if (!made) return std::nullopt;
    arguments.push_back(std::move(*made));
  }
  return Atom(atom.predicate(), arguments);
}

}  // namespace latchwork::pttp

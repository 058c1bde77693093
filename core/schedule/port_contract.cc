// SPDX-License-Identifier: BSD-3-Clause
#include "core/schedule/port_contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "latchwork/logic/term.h"

namespace latchwork::schedule {
namespace {

using logic::Term;

bool IsFinite(const Term& term) {
  std::vector<const Term*> open = {&term};
  while (!open.empty()) {
    const Term* next = open.back();
    open.pop_back();
    if (next->kind() == Term::Kind::kReal && !std::isfinite(next->real())) return false;
    for (const Term& argument : next->arguments()) open.push_back(&argument);
  }
  return true;
}

bool IsOfType(const Term& term, sdk::ArgumentType type) {
  switch (type) {
    case sdk::ArgumentType::kInteger:
      return term.kind() == Term::Kind::kInteger;
    case sdk::ArgumentType::kReal:
      return term.is_number() && std::isfinite(term.number());
    case sdk::ArgumentType::kSymbol:
      return term.kind() == Term::Kind::kConstant;
    case sdk::ArgumentType::kAny:
      return term.kind() != Term::Kind::kCompound ? !term.is_variable() && IsFinite(term)
                                                  : term.is_ground() && IsFinite(term);
  }
  return false;
}

std::string_view Wanted(sdk::ArgumentType type) {
  switch (type) {
    case sdk::ArgumentType::kInteger:
      return "an integer";
    case sdk::ArgumentType::kReal:
      return "a finite number";
    case sdk::ArgumentType::kSymbol:
      return "a name";
    case sdk::ArgumentType::kAny:
      return "a ground term with finite numbers";
  }
  return "";
}

}  // namespace

PortContract::PortContract(const sdk::PortSpec& port, logic::SymbolTable& symbols)
    : port_(port.name) {
  for (const sdk::PredicateSpec& spec : port.predicates) {
    Predicate predicate{{symbols.Intern(spec.name), spec.arguments.size()}, {}};
    for (const sdk::ArgumentSpec& argument : spec.arguments) {
      predicate.types.push_back(argument.type);
    }
    predicates_.push_back(std::move(predicate));
  }
}

const PortContract::Predicate* PortContract::Find(const logic::Atom& atom) const {
  const auto found =
      std::find_if(predicates_.begin(), predicates_.end(),
                   [&](const Predicate& each) { return each.name == logic::NameOf(atom); });
  return found == predicates_.end() ? nullptr : &*found;
}

bool PortContract::Declares(const logic::Atom& atom) const { return Find(atom) != nullptr; }

std::string PortContract::Offence(const logic::Fact& fact) const {
  const Predicate* predicate = Find(fact);
  if (predicate == nullptr) {
    return fmt::format("port {} does not declare {}", port_, logic::ToString(logic::NameOf(fact)));
  }
  for (std::size_t i = 0; i < fact.arity(); ++i) {
    if (IsOfType(fact.argument(i), predicate->types[i])) continue;
    return fmt::format("argument {} of {} must be {}", i + 1, logic::ToString(predicate->name),
                       Wanted(predicate->types[i]));
  }
  return {};
}

}  // namespace latchwork::schedule

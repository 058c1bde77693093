// SPDX-License-Identifier: BSD-3-Clause
#include "apps/check_proof/skolem_check.h"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

namespace latchwork::check_proof {
namespace {

using logic::Symbol;
using logic::Term;
using logic::Variable;
using Kind = Tree::Kind;

class SkolemCheck {
 public:
  explicit SkolemCheck(const std::set<Symbol>& functions) : functions_(functions) {}

  std::string Run(const Tree& before, const Tree& after) {
    if (!Compare(before, after)) return "it is not its parent with terms for variables";
    for (const auto& [variable, tree] : existential_) {
      std::string fault = CheckArguments(variable, *tree);
      if (!fault.empty()) return fault;
    }
    return {};
  }

 private:
  bool Compare(const Tree& before, const Tree& after) {
    if (before.kind == Kind::kExists) {
      for (const Variable each : before.variables) existential_.emplace(each, &before.children[0]);
      return Compare(before.children[0], after);
    }
    if (before.kind != after.kind || before.variables.size() != after.variables.size() ||
        before.children.size() != after.children.size()) {
      return false;
    }
    for (std::size_t i = 0; i < before.variables.size(); ++i) {
      universal_.emplace(before.variables[i], after.variables[i]);
    }
    if (before.kind == Kind::kLiteral) return CompareLiterals(before.literal, after.literal);
    for (std::size_t i = 0; i < before.children.size(); ++i) {
      if (!Compare(before.children[i], after.children[i])) return false;
    }
    return true;
  }

  bool CompareLiterals(const logic::Literal& before, const logic::Literal& after) {
    if (before.positive != after.positive || NameOf(before.atom) != NameOf(after.atom)) {
      return false;
    }
    for (std::size_t i = 0; i < before.atom.arity(); ++i) {
      if (!CompareTerms(before.atom.argument(i), after.atom.argument(i))) return false;
    }
    return true;
  }

  bool CompareTerms(const Term& before, const Term& after) {
    if (before.is_variable()) return CompareVariable(before.variable(), after);
    if (before.is_ground() || after.is_variable()) return before == after;
    const auto arguments = before.arguments();
    const auto others = after.arguments();
    if (arguments.size() != others.size() || before.symbol() != after.symbol()) return false;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (!CompareTerms(arguments[i], others[i])) return false;
    }
    return true;
  }

  bool CompareVariable(Variable variable, const Term& after) {
    const auto universal = universal_.find(variable);
    if (universal != universal_.end()) return after == Term::Var(universal->second);
    if (!existential_.contains(variable)) return false;
    return terms_.emplace(variable, after).first->second == after;
  }

  std::string CheckArguments(Variable variable, const Tree& below) {
    const auto found = terms_.find(variable);
    if (found == terms_.end()) return {};
    const Term& term = found->second;
    if (term.is_variable() || term.is_number() || !functions_.contains(term.symbol())) {
      return "'" + ToString(term) + "' is no new function of universal variables";
    }
    const std::string name(term.symbol().name());
    if (!used_.insert(term.symbol()).second) return "'" + name + "' stands for two variables";
    std::set<Variable> given;
    for (const Term& argument : term.arguments()) {
      if (!argument.is_variable() || !given.insert(argument.variable()).second) {
        return "the arguments of '" + name + "' are not distinct variables";
      }
    }
    for (const Variable needed : DependsOn(variable, below)) {
      if (!given.contains(needed)) return "'" + name + "' lacks an argument that it depends on";
    }
    return {};
  }

  std::vector<Variable> DependsOn(Variable variable, const Tree& below) const {
    std::vector<Variable> free;
    const auto add = [&](const Tree& tree) {
      const auto of_tree = FreeVariables(tree);
      if (std::find(of_tree.begin(), of_tree.end(), variable) == of_tree.end()) return;
      free.insert(free.end(), of_tree.begin(), of_tree.end());
    };
    if (below.kind == Kind::kAnd || below.kind == Kind::kOr) {
      for (const Tree& child : below.children) add(child);
    } else {
      add(below);
    }
    std::vector<Variable> needed;
    for (const Variable each : free) {
      if (each == variable) continue;
      const auto universal = universal_.find(each);
      if (universal != universal_.end()) {
        needed.push_back(universal->second);
      } else if (const auto term = terms_.find(each); term != terms_.end()) {
        for (const Term& argument : term->second.arguments()) {
          if (argument.is_variable()) needed.push_back(argument.variable());
        }
      }
    }
    return needed;
  }

  const std::set<Symbol>& functions_;
  std::map<Variable, Variable> universal_;
  std::map<Variable, const Tree*> existential_;
  std::map<Variable, Term> terms_;
  std::set<Symbol> used_;
};

}  // namespace

std::string CheckSkolemization(const Tree& before, const Tree& after,
                               const std::set<Symbol>& functions) {
  return SkolemCheck(functions).Run(before, after);
}

}  // namespace latchwork::check_proof

// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "apps/latchwork/diff_theory.h"
#include "latchwork/sdk/random.h"

namespace latchwork::app {
namespace {

constexpr std::size_t kConstants = 3;
constexpr std::size_t kVariables = 3;
constexpr std::array<std::size_t, 6> kArities = {0, 0, 1, 1, 1, 2};

class Maker {
 public:
  Maker(std::uint64_t seed, std::uint64_t number, logic::SymbolTable& symbols)
      : stream_(seed, "theories"), number_(number), symbols_(symbols) {}

  DiffTheory Make() {
    has_functions_ = Chance(20);
    DiffTheory theory;
    const std::size_t clauses = 3 + Draw(6);
    while (theory.clauses.size() < clauses) theory.clauses.push_back(MakeClause(theory));
    theory.latches.resize(2);
    for (std::size_t i = 0; i < 2; ++i) {
      theory.latches[i].port = fmt::format("latch{}", i);
      theory.latches[i].version = 1;
      for (std::size_t k = Draw(4); k > 0; --k) {
        theory.latches[i].facts.push_back(MakeAtom(Draw(kArities.size()), 0));
      }
    }
    for (std::size_t i = 0; i < 2; ++i) theory.body.goals.push_back(MakeGoal());
    for (std::size_t i = Draw(3); i > 0; --i) AddMinimized(theory);
    theory.budget.inferences = 50'000;
    theory.budget.depth = 32;
    return theory;
  }

 private:
  std::size_t Draw(std::size_t count) {
    return static_cast<std::size_t>(stream_.Index(count, number_, draws_++));
  }
  bool Chance(std::size_t percent) { return Draw(100) < percent; }
  logic::Symbol PredicateSymbol(std::size_t predicate) {
    return symbols_.Intern(fmt::format("p{}", predicate));
  }

  /// Arguments are constants, or one of so many variables.
  logic::Atom MakeAtom(std::size_t predicate, std::size_t variables) {
    std::vector<logic::Term> arguments;
    for (std::size_t i = 0; i < kArities[predicate]; ++i) {
      arguments.push_back(
          variables > 0 && Chance(75)
              ? logic::Term::Var(static_cast<logic::Variable>(Draw(variables)))
              : logic::Term::Constant(symbols_.Intern(std::string(1, "abc"[Draw(kConstants)]))));
    }
    return {PredicateSymbol(predicate), arguments};
  }

  /// Premises first, so that conclusions use their variables only.
  logic::Clause MakeClause(const DiffTheory& theory) {
    logic::Clause clause;
    clause.name = fmt::format("c{}", theory.clauses.size());
    const std::size_t kind = Draw(100);
    const std::size_t premises = kind < 15 ? 0 : 1 + Draw(2);
    const std::size_t conclusions = kind >= 85 ? 2 : kind >= 75 && premises > 0 ? 0 : 1;
    std::vector<logic::Term> bound;
    std::size_t highest = 0;
    for (std::size_t i = 0; i < premises; ++i) {
      const std::size_t predicate = Draw(kArities.size());
      highest = std::max(highest, predicate);
      clause.literals.push_back({false, MakeAtom(predicate, kVariables)});
      for (const logic::Term& argument : clause.literals.back().atom.arguments()) {
        if (argument.is_variable()) bound.push_back(argument);
      }
    }
    for (std::size_t i = 0; i < conclusions; ++i) {
      clause.literals.push_back({true, MakeConclusion(bound, highest)});
    }
    for (std::size_t i = 0; i < kVariables; ++i) {
      clause.variable_names.push_back(std::string(1, "XYZ"[i]));
    }
    return clause;
  }

  /// Terms grow only from a predicate to a higher one, so that there are not too many.
  logic::Atom MakeConclusion(const std::vector<logic::Term>& bound, std::size_t highest) {
    const std::size_t predicate = Draw(kArities.size());
    const bool grows = has_functions_ && predicate > highest && Chance(50);
    std::vector<logic::Term> arguments;
    for (std::size_t i = 0; i < kArities[predicate]; ++i) {
      logic::Term term = logic::Term::Constant(symbols_.Intern("a"));
      if (!bound.empty() && Chance(85)) term = bound[Draw(bound.size())];
      arguments.push_back(grows ? logic::Term::Compound(symbols_.Intern("f"), {term}) : term);
    }
    return {PredicateSymbol(predicate), arguments};
  }

  sdk::Goal MakeGoal() {
    const std::size_t predicate = Draw(kArities.size());
    std::vector<logic::Term> variables;
    for (std::size_t i = 0; i < kArities[predicate]; ++i) {
      variables.push_back(logic::Term::Var(static_cast<logic::Variable>(i)));
    }
    return {{PredicateSymbol(predicate), variables}, variables.size(), sdk::Goal::Answers::kAll, 0};
  }

  void AddMinimized(DiffTheory& theory) {
    const std::size_t predicate = Draw(kArities.size());
    const logic::PredicateName name = {PredicateSymbol(predicate), kArities[predicate]};
    for (const auto& known : theory.body.minimized) {
      if (known.predicate == name) return;
    }
    theory.body.minimized.push_back({name});
  }

  sdk::RandomStream stream_;
  std::uint64_t number_;
  std::uint64_t draws_ = 0;
  logic::SymbolTable& symbols_;
  bool has_functions_ = false;
};

}  // namespace

DiffTheory MakeRandomTheory(std::uint64_t seed, std::uint64_t number, logic::SymbolTable& symbols) {
  return Maker(seed, number, symbols).Make();
}

}  // namespace latchwork::app

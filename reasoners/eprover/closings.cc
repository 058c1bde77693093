// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/eprover/closings.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reasoners/contrapositives/signed_graph.h"

namespace latchwork::eprover {
namespace {

using contrapositives::Signed;
using contrapositives::SignedGraph;
using contrapositives::SignedOf;

class Numbers {
 public:
  std::size_t Of(const logic::PredicateName& name) {
    const auto [found, is_new] = numbers_.emplace(name, names_.size());
    if (is_new) names_.push_back(name);
    return found->second;
  }
  const std::vector<logic::PredicateName>& names() const { return names_; }

 private:
  std::map<logic::PredicateName, std::size_t> numbers_;
  std::vector<logic::PredicateName> names_;
};

bool Contains(const auto& range, const auto& value) {
  return std::ranges::find(range, value) != range.end();
}

/// Where equations can be concluded, they turn arguments into others, and what holds of one
/// argument and not of another makes these unequal.
void AddCongruence(std::size_t equality, const Numbers& numbers,
                   std::vector<SignedGraph::Rule>& rules) {
  const Signed equal = SignedOf(equality, true);
  for (std::size_t i = 0; i < numbers.names().size(); ++i) {
    if (i == equality || numbers.names()[i].arity == 0) continue;
    const Signed holds = SignedOf(i, true);
    const Signed fails = SignedOf(i, false);
    rules.push_back({holds, {holds, equal}});
    rules.push_back({fails, {fails, equal}});
    rules.push_back({SignedOf(equality, false), {holds, fails}});
  }
}

SignedGraph MakeGraph(const sdk::Body& body, std::span<const logic::Clause> clauses,
                      const std::set<logic::PredicateName>& minimized, logic::Symbol equality,
                      Numbers& numbers) {
  for (const auto& goal : body.goals) numbers.Of(NameOf(goal.pattern));
  for (const auto& name : minimized) numbers.Of(name);
  for (const auto& name : body.inputs) numbers.Of(name);
  std::set<logic::PredicateName> given(body.inputs.begin(), body.inputs.end());
  for (const auto& fact : body.facts) given.insert(NameOf(fact));
  std::vector<SignedGraph::Rule> rules;
  for (const logic::Clause& clause : clauses) {
    for (std::size_t head = 0; head < clause.literals.size(); ++head) {
      SignedGraph::Rule& rule = rules.emplace_back();
      for (std::size_t i = 0; i < clause.literals.size(); ++i) {
        const logic::Literal& literal = clause.literals[i];
        const std::size_t number = numbers.Of(NameOf(literal.atom));
        if (i == head) {
          rule.head = SignedOf(number, literal.positive);
        } else {
          rule.body.push_back(SignedOf(number, !literal.positive));
        }
      }
    }
  }
  const logic::PredicateName equation{equality, 2};
  const std::size_t equal = numbers.Of(equation);
  const bool concludes_equations =
      std::ranges::find(rules, SignedOf(equal, true), &SignedGraph::Rule::head) != rules.end();
  if (concludes_equations || given.contains(equation)) AddCongruence(equal, numbers, rules);
  std::vector<SignedGraph::Predicate> predicates(2 * numbers.names().size());
  for (std::size_t i = 0; i < numbers.names().size(); ++i) {
    const logic::PredicateName& name = numbers.names()[i];
    const bool is_equality = name.symbol == equality;
    predicates[SignedOf(i, true)] = {true, given.contains(name) || is_equality};
    predicates[SignedOf(i, false)] = {false, minimized.contains(name) || is_equality};
  }
  for (const auto& goal : body.goals) {
    predicates[SignedOf(numbers.Of(NameOf(goal.pattern)), true)].is_root = true;
  }
  return {std::move(rules), std::move(predicates)};
}

bool Occurs(const logic::Term& variable, const logic::Term& term) {
  return term == variable ||
         std::ranges::any_of(term.arguments(), [&](const logic::Term& argument) {
           return Occurs(variable, argument);
         });
}

/// Whether the other literals have the variable, but never as an argument of their own.
bool IsOnlyInside(const logic::Clause& clause, const logic::Literal& literal,
                  const logic::Term& variable) {
  bool is_inside = false;
  for (const logic::Literal& other : clause.literals) {
    if (&other == &literal) continue;
    for (const logic::Term& argument : other.atom.arguments()) {
      if (argument == variable) return false;
      is_inside = is_inside || Occurs(variable, argument);
    }
  }
  return is_inside;
}

}  // namespace

Closings::Closings(const sdk::Body& body, std::span<const logic::Clause> clauses,
                   logic::SymbolTable& symbols) {
  FindNeeds(body, clauses, symbols);
  Join(clauses);
  CheckFinite(clauses);
}

void Closings::FindNeeds(const sdk::Body& body, std::span<const logic::Clause> clauses,
                         logic::SymbolTable& symbols) {
  std::set<logic::PredicateName> minimized;
  for (const auto& each : body.minimized) minimized.insert(each.predicate);
  Numbers numbers;
  const SignedGraph graph = MakeGraph(body, clauses, minimized, symbols.Intern("="), numbers);
  // Everything below a goal, or below the proof of something that is closed for one.
  std::vector<std::size_t> needed;
  std::map<std::size_t, std::vector<std::size_t>> rests_on;
  const auto add_needs = [&](Signed key, std::vector<std::size_t>& needs) {
    const std::vector<bool> below = graph.Below(key);
    for (std::size_t i = 0; i < numbers.names().size(); ++i) {
      if (!minimized.contains(numbers.names()[i]) || !below[SignedOf(i, false)]) continue;
      if (!Contains(needs, i)) needs.push_back(i);
    }
  };
  for (const auto& goal : body.goals) {
    add_needs(SignedOf(numbers.Of(NameOf(goal.pattern)), true), needed);
  }
  for (std::size_t i = 0; i < needed.size(); ++i) {
    auto& needs = rests_on[needed[i]];
    add_needs(SignedOf(needed[i], true), needs);
    for (const std::size_t need : needs) {
      if (!Contains(needed, need)) needed.push_back(need);
    }
  }
  while (!needed.empty()) {
    const auto next = std::ranges::find_if(needed, [&](std::size_t candidate) {
      return std::ranges::none_of(rests_on[candidate],
                                  [&](std::size_t need) { return Contains(needed, need); });
    });
    if (next == needed.end()) {
      obstacle_ = fmt::format("a default rests on itself: closing needs the closing of {}",
                              ToString(numbers.names()[needed.front()]));
      return;
    }
    order_.push_back({numbers.names()[*next], graph.HasRules(SignedOf(*next, true))});
    needed.erase(next);
  }
}

std::size_t Closings::ClassOf(const Position& position) {
  const auto [found, is_new] = positions_.emplace(position, parents_.size());
  if (is_new) parents_.push_back(parents_.size());
  std::size_t root = found->second;
  while (parents_[root] != root) root = parents_[root];
  return root;
}

void Closings::Unite(std::size_t a, std::size_t b) { parents_[std::max(a, b)] = std::min(a, b); }

void Closings::Join(std::span<const logic::Clause> clauses) {
  std::map<Position, std::set<logic::Term>> terms;
  for (const logic::Clause& clause : clauses) {
    std::map<logic::Variable, Position> seen;
    for (const logic::Literal& literal : clause.literals) {
      for (std::size_t i = 0; i < literal.atom.arity(); ++i) {
        const Position position = {NameOf(literal.atom), i};
        ClassOf(position);
        const logic::Term& argument = literal.atom.argument(i);
        if (argument.is_ground()) terms[position].insert(argument);
        if (!argument.is_variable()) continue;
        const auto [first, is_new] = seen.emplace(argument.variable(), position);
        if (!is_new) Unite(ClassOf(first->second), ClassOf(position));
      }
    }
  }
  for (const auto& [position, ground] : terms) {
    terms_[ClassOf(position)].insert(ground.begin(), ground.end());
  }
}

/// Terms that are made, or taken out of others, could be arguments without end.
void Closings::CheckFinite(std::span<const logic::Clause> clauses) {
  std::set<std::size_t> closed;
  for (const Closing& closing : order_) {
    for (std::size_t i = 0; i < closing.predicate.arity; ++i) {
      closed.insert(ClassOf({closing.predicate, i}));
    }
  }
  for (const logic::Clause& clause : clauses) {
    CheckCarried(clause);
    for (const logic::Literal& literal : clause.literals) {
      for (std::size_t i = 0; i < literal.atom.arity(); ++i) {
        const logic::Term& argument = literal.atom.argument(i);
        const std::size_t own = ClassOf({NameOf(literal.atom), i});
        if (argument.is_variable() || argument.is_ground()) continue;
        if (!closed.contains(own) || !obstacle_.empty()) continue;
        obstacle_ = fmt::format("'{}' makes terms that a minimized predicate may hold of: {}",
                                clause.name, ToString(literal, clause.variable_names));
        place_ = clause.place;
      }
    }
  }
}

/// A value that only a compound term carries to a default is not among the terms that are known.
void Closings::CheckCarried(const logic::Clause& clause) {
  for (const logic::Literal& literal : clause.literals) {
    const bool is_closed =
        literal.positive && std::ranges::any_of(order_, [&](const Closing& closing) {
          return closing.predicate == NameOf(literal.atom);
        });
    if (!is_closed) continue;
    for (const logic::Term& argument : literal.atom.arguments()) {
      if (!argument.is_variable() || !obstacle_.empty() ||
          !IsOnlyInside(clause, literal, argument)) {
        continue;
      }
      obstacle_ = fmt::format("in '{}', only a compound term says what {} may be", clause.name,
                              ToString(literal, clause.variable_names));
      place_ = clause.place;
    }
  }
}

std::optional<std::vector<logic::Fact>> Closings::Instances(const logic::PredicateName& predicate,
                                                            std::span<const logic::Fact> facts,
                                                            std::size_t most) {
  std::vector<std::set<logic::Term>> domains;
  for (std::size_t i = 0; i < predicate.arity; ++i) {
    domains.push_back(terms_[ClassOf({predicate, i})]);
  }
  for (const logic::Fact& fact : facts) {
    for (std::size_t i = 0; i < fact.arity(); ++i) {
      const std::size_t own = ClassOf({NameOf(fact), i});
      for (std::size_t k = 0; k < predicate.arity; ++k) {
        if (ClassOf({predicate, k}) == own) domains[k].insert(fact.argument(i));
      }
    }
  }
  std::vector<std::vector<logic::Term>> tuples = {{}};
  for (const auto& domain : domains) {
    if (tuples.size() * domain.size() > most) return std::nullopt;
    std::vector<std::vector<logic::Term>> longer;
    for (const auto& tuple : tuples) {
      for (const logic::Term& term : domain) {
        longer.push_back(tuple);
        longer.back().push_back(term);
      }
    }
    tuples = std::move(longer);
  }
  std::vector<logic::Fact> instances;
  for (const auto& tuple : tuples) instances.emplace_back(predicate.symbol, tuple);
  return instances;
}

}  // namespace latchwork::eprover

// SPDX-License-Identifier: BSD-3-Clause
#include "tests/core/logic/finite_models.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>

namespace latchwork::logic {

namespace {

using Elements = std::vector<std::size_t>;

/// All functions from `count` places to elements, one after the other; false after the last.
bool Next(Elements& values, std::size_t size) {
  for (std::size_t& value : values) {
    if (++value < size) return true;
    value = 0;
  }
  return false;
}

class Evaluator {
 public:
  Evaluator(std::size_t size, const Elements& truth) : size_(size), truth_(truth) {}

  bool Holds(const Formula& formula) {
    const auto children = formula.children();
    const auto holds = [this](const Formula& child) { return Holds(child); };
    switch (formula.kind()) {
      case Formula::Kind::kTrue:
        return true;
      case Formula::Kind::kFalse:
        return false;
      case Formula::Kind::kAtom:
        return HoldsAtom(formula.atom());
      case Formula::Kind::kNot:
        return !Holds(children[0]);
      case Formula::Kind::kAnd:
        return std::all_of(children.begin(), children.end(), holds);
      case Formula::Kind::kOr:
        return std::any_of(children.begin(), children.end(), holds);
      case Formula::Kind::kImplies:
        return !Holds(children[0]) || Holds(children[1]);
      case Formula::Kind::kEquivalent:
        return Holds(children[0]) == Holds(children[1]);
      default:
        return HoldsQuantified(formula);
    }
  }

 private:
  bool HoldsAtom(const Atom& atom) {
    const std::string_view name = atom.predicate().name();
    if (atom.arity() == 0) return truth_[name == "r" ? 0 : 1] > 0;
    const std::size_t element = values_.at(atom.argument(0).variable());
    return truth_[2 + (name == "p" ? 0 : size_) + element] > 0;
  }

  bool HoldsQuantified(const Formula& formula) {
    const bool is_forall = formula.kind() == Formula::Kind::kForall;
    Elements choice(formula.variables().size());
    do {
      for (std::size_t i = 0; i < choice.size(); ++i) values_[formula.variables()[i]] = choice[i];
      if (Holds(formula.children()[0]) != is_forall) return !is_forall;
    } while (Next(choice, size_));
    return is_forall;
  }

  std::size_t size_;
  const Elements& truth_;
  std::map<Variable, std::size_t> values_;
};

/// Propositional clauses over numbered variables: n or -n.
using Propositional = std::vector<std::vector<int>>;

/// Davis, Logemann and Loveland; false when nothing satisfies the clauses.
bool Satisfy(Propositional clauses) {
  while (true) {
    const auto shortest =
        std::min_element(clauses.begin(), clauses.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); });
    if (shortest == clauses.end()) return true;
    if (shortest->empty()) return false;
    const int literal = shortest->front();
    const auto assume = [&clauses](int chosen) {
      Propositional rest;
      for (const auto& clause : clauses) {
        if (std::find(clause.begin(), clause.end(), chosen) != clause.end()) continue;
        auto& kept = rest.emplace_back(clause);
        kept.erase(std::remove(kept.begin(), kept.end(), -chosen), kept.end());
      }
      return rest;
    };
    if (shortest->size() > 1 && Satisfy(assume(literal))) return true;
    clauses = assume(shortest->size() > 1 ? -literal : literal);
  }
}

/// Grounds clauses over a finite domain. A function term stands for every element that it may be
/// equal to, on the condition that it is.
class Grounder {
 public:
  explicit Grounder(std::size_t size) : size_(size) {}

  void Add(const Clause& clause) {
    Elements values(clause.variable_names.size());
    do {
      std::vector<std::string> terms;
      for (const Literal& literal : clause.literals) {
        for (const Term& term : literal.atom.arguments()) {
          if (!term.is_variable()) terms.push_back(Name(term, values));
        }
      }
      AddForAllValues(clause, values, terms);
    } while (Next(values, size_));
  }

  Propositional Take() {
    for (const std::string& term : terms_) {
      auto& some = clauses_.emplace_back();
      for (std::size_t i = 0; i < size_; ++i) {
        some.push_back(Number(term + "=" + std::to_string(i)));
      }
    }
    return std::move(clauses_);
  }

 private:
  int Number(const std::string& name) {
    return numbers_.emplace(name, static_cast<int>(numbers_.size()) + 1).first->second;
  }

  std::string Name(const Term& term, const Elements& values) {
    if (term.is_variable()) return std::to_string(values.at(term.variable()));
    std::string name(term.symbol().name());
    for (const Term& argument : term.arguments()) name += "," + Name(argument, values);
    return name;
  }

  void AddForAllValues(const Clause& clause, const Elements& values,
                       const std::vector<std::string>& terms) {
    Elements of_terms(terms.size());
    do {
      auto& ground = clauses_.emplace_back();
      std::size_t next = 0;
      for (const Literal& literal : clause.literals) {
        std::string name(literal.atom.predicate().name());
        for (const Term& term : literal.atom.arguments()) {
          if (term.is_variable()) {
            name += " " + Name(term, values);
            continue;
          }
          const std::string element = std::to_string(of_terms[next]);
          name += " " + element;
          ground.push_back(-Number(terms[next] + "=" + element));
          ++next;
        }
        ground.push_back(literal.positive ? Number(name) : -Number(name));
      }
      terms_.insert(terms_.end(), terms.begin(), terms.end());
    } while (Next(of_terms, size_));
    std::sort(terms_.begin(), terms_.end());
    terms_.erase(std::unique(terms_.begin(), terms_.end()), terms_.end());
  }

  std::size_t size_;
  Propositional clauses_;
  std::vector<std::string> terms_;
  std::map<std::string, int> numbers_;
};

}  // namespace

bool HasModel(const Formula& formula, std::size_t size) {
  Elements truth(2 + 2 * size);
  do {
    if (Evaluator(size, truth).Holds(formula)) return true;
  } while (Next(truth, 2));
  return false;
}

bool HasModel(const std::vector<Clause>& clauses, std::size_t size) {
  Grounder grounder(size);
  for (const Clause& clause : clauses) grounder.Add(clause);
  return Satisfy(grounder.Take());
}

}  // namespace latchwork::logic

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/explanation/near_miss.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "latchwork/logic/arithmetic.h"

namespace latchwork::circumscription {
namespace {

using logic::Literal;
using logic::Term;

constexpr std::size_t kMaxVisits = 100'000;

/// Follows the premises of one clause as far as facts go.
class Attempt {
 public:
  Attempt(const Rule& rule, const Evaluator& evaluator, const logic::Arithmetic& arithmetic)
      : rule_(rule),
        clause_(evaluator.program().clauses()[rule.clause]),
        evaluator_(evaluator),
        arithmetic_(arithmetic),
        values_(clause_.variable_names.size()) {}

  /// Nothing: the clause does not conclude anything like `target`.
  std::optional<sdk::NearMiss> Follow(const Head& concluded, const logic::Atom& target) {
    const Literal& head = clause_.literals[concluded.literal];
    if (NameOf(head.atom) != NameOf(target)) return std::nullopt;
    for (std::size_t i = 0; i < target.arity(); ++i) {
      if (!MatchHead(head.atom.argument(i), target.argument(i))) return std::nullopt;
    }
    for (const Step& step : rule_.steps) {
      if (step.literal != kNoIndex) steps_.push_back(&step);
    }
    miss_ = {clause_.name, clause_.place, 0, steps_.size(), {}};
    Visit(0);
    return miss_;
  }

 private:
  bool MatchHead(const Term& pattern, const Term& target) {
    if (target.is_variable() || IsComputed(pattern)) return true;
    return Match(pattern, target);
  }

  bool Match(const Term& pattern, const Term& value) {
    if (pattern.is_variable()) {
      std::optional<Term>& known = values_[pattern.variable()];
      if (known) return *known == value;
      known = value;
      return true;
    }
    if (IsComputed(pattern)) {
      const Term computed = Instance(pattern);
      return !computed.is_ground() || computed == value;
    }
    const auto arguments = pattern.arguments();
    if (arguments.empty()) return pattern == value;
    if (value.kind() != Term::Kind::kCompound || value.symbol() != pattern.symbol() ||
        value.arguments().size() != arguments.size()) {
      return false;
    }
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (!Match(arguments[i], value.arguments()[i])) return false;
    }
    return true;
  }

  bool IsComputed(const Term& term) const {
    return term.kind() == Term::Kind::kCompound &&
           arithmetic_.FindFunction(term.symbol(), term.arguments().size()).has_value();
  }

  Term Instance(const Term& term) const {
    if (term.is_variable()) return values_[term.variable()].value_or(term);
    if (term.kind() != Term::Kind::kCompound) return term;
    std::vector<Term> arguments;
    for (const Term& argument : term.arguments()) arguments.push_back(Instance(argument));
    Term instance = Term::Compound(term.symbol(), std::move(arguments));
    if (!instance.is_ground()) return instance;
    return arithmetic_.Normalize(instance).value_or(instance);
  }

  logic::Atom Instance(const logic::Atom& atom) const {
    std::vector<Term> arguments;
    for (const Term& argument : atom.arguments()) arguments.push_back(Instance(argument));
    return {atom.predicate(), arguments};
  }

  /// Whether all premises from the given one on can be met.
  bool Visit(std::size_t next) {
    if (next == steps_.size() || ++visits_ > kMaxVisits) return true;
    const Step& step = *steps_[next];
    const Literal& literal = clause_.literals[step.literal];
    Note(next, literal);
    if (step.kind == Step::Kind::kJoin || step.kind == Step::Kind::kCall) {
      return VisitFacts(next, step, literal);
    }
    const std::vector<std::optional<Term>> before = values_;
    if (Holds(step, literal) && Visit(next + 1)) return true;
    values_ = before;
    return false;
  }

  bool VisitFacts(std::size_t next, const Step& step, const Literal& literal) {
    const std::vector<std::optional<Term>> before = values_;
    const std::uint32_t rows = evaluator_.table(step.relation).size();
    for (std::uint32_t row = 0; row < rows; ++row) {
      const logic::Fact fact = evaluator_.FactOf({static_cast<std::uint32_t>(step.relation), row});
      bool matches = true;
      for (std::size_t i = 0; i < fact.arity() && matches; ++i) {
        matches = Match(literal.atom.argument(i), fact.argument(i));
      }
      if (matches && Visit(next + 1)) return true;
      values_ = before;
    }
    return false;
  }

  bool Holds(const Step& step, const Literal& literal) {
    const logic::Atom atom = Instance(literal.atom);
    if (step.kind == Step::Kind::kAbsent) return !IsFact(step.relation, atom);
    if (step.kind == Step::Kind::kEqual) {
      if (step.negated) return !(atom.argument(0) == atom.argument(1));
      return atom.argument(1).is_ground() ? Match(literal.atom.argument(0), atom.argument(1))
                                          : Match(literal.atom.argument(1), atom.argument(0));
    }
    const auto holds = logic::Arithmetic::Evaluate(step.test, atom.arguments());
    return holds && *holds != step.negated;
  }

  bool IsFact(std::size_t relation, const logic::Atom& atom) const {
    const std::uint32_t rows = evaluator_.table(relation).size();
    for (std::uint32_t row = 0; row < rows; ++row) {
      if (evaluator_.FactOf({static_cast<std::uint32_t>(relation), row}) == atom) return true;
    }
    return false;
  }

  void Note(std::size_t met, const Literal& literal) {
    if (!miss_.lacks.empty() && met <= miss_.met) return;
    miss_.met = met;
    // A premise is the contrary of its literal.
    miss_.lacks =
        ToString(Literal{!literal.positive, Instance(literal.atom)}, clause_.variable_names);
  }

  const Rule& rule_;
  const logic::Clause& clause_;
  const Evaluator& evaluator_;
  const logic::Arithmetic& arithmetic_;
  std::vector<std::optional<Term>> values_;
  std::vector<const Step*> steps_;
  sdk::NearMiss miss_;
  std::size_t visits_ = 0;
};

}  // namespace

std::vector<sdk::NearMiss> NearMissesOf(const logic::Atom& target, const Evaluator& evaluator,
                                        logic::SymbolTable& symbols) {
  const logic::Arithmetic arithmetic(symbols);
  std::vector<sdk::NearMiss> misses;
  for (const Rule& rule : evaluator.program().rules()) {
    for (const Head& head : rule.heads) {
      auto miss = Attempt(rule, evaluator, arithmetic).Follow(head, target);
      if (!miss) continue;
      misses.push_back(*std::move(miss));
      break;
    }
  }
  std::stable_sort(misses.begin(), misses.end(), [](const auto& a, const auto& b) {
    return a.premises - a.met < b.premises - b.met;
  });
  return misses;
}

void AddMisses(std::vector<sdk::NearMiss> more, std::vector<sdk::NearMiss>& misses) {
  const auto known = static_cast<std::ptrdiff_t>(misses.size());
  for (sdk::NearMiss& miss : more) {
    const bool is_known =
        std::any_of(misses.begin(), misses.begin() + known,
                    [&](const sdk::NearMiss& each) { return each.clause == miss.clause; });
    if (!is_known) misses.push_back(std::move(miss));
  }
}

}  // namespace latchwork::circumscription

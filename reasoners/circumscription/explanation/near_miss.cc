// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/explanation/near_miss.h"

#include <algorithm>
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

  /// Nothing: the clause does not conclude anything like `target`, or its premises all hold.
  std::optional<sdk::NearMiss> Follow(const Head& concluded, const logic::Atom& target) {
    const Literal& head = clause_.literals[concluded.literal];
    if (NameOf(head.atom) != NameOf(target)) return std::nullopt;
    head_ = &head.atom;
    target_ = Apart(target);
    for (std::size_t i = 0; i < target.arity(); ++i) {
      if (!Unify(head.atom.argument(i), target_.argument(i))) return std::nullopt;
    }
    for (const Step& step : rule_.steps) {
      if (step.literal != kNoIndex) steps_.push_back(&step);
    }
    miss_ = {clause_.name, clause_.place, 0, steps_.size(), {}};
    if (Visit(0) && visits_ <= kMaxVisits) return std::nullopt;
    return miss_;
  }

 private:
  /// The target with variables that are none of the clause's.
  logic::Atom Apart(const logic::Atom& target) {
    std::vector<Term> arguments;
    for (const Term& argument : target.arguments()) arguments.push_back(Apart(argument));
    return {target.predicate(), arguments};
  }

  Term Apart(const Term& term) {
    if (term.is_variable()) {
      const auto variable =
          static_cast<logic::Variable>(clause_.variable_names.size() + term.variable());
      values_.resize(std::max<std::size_t>(values_.size(), variable + 1));
      return Term::Var(variable);
    }
    if (term.kind() != Term::Kind::kCompound) return term;
    std::vector<Term> arguments;
    for (const Term& argument : term.arguments()) arguments.push_back(Apart(argument));
    return Term::Compound(term.symbol(), std::move(arguments));
  }

  Term Walk(Term term) const {
    while (term.is_variable() && values_[term.variable()]) term = *values_[term.variable()];
    return term;
  }

  /// What is computed is equal to anything until it can be computed.
  bool Unify(const Term& one, const Term& other) {
    Term a = Walk(one);
    Term b = Walk(other);
    if (IsComputed(a)) a = Instance(a);
    if (IsComputed(b)) b = Instance(b);
    if (IsComputed(a) || IsComputed(b) || a == b) return true;
    if (b.is_variable()) return Bind(b.variable(), a);
    if (a.is_variable()) return Bind(a.variable(), b);
    const auto parts = a.arguments();
    if (parts.empty() || parts.size() != b.arguments().size() || a.symbol() != b.symbol()) {
      return false;
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!Unify(parts[i], b.arguments()[i])) return false;
    }
    return true;
  }

  bool Bind(logic::Variable variable, const Term& term) {
    if (Occurs(variable, term)) return false;
    values_[variable] = term;
    return true;
  }

  bool Occurs(logic::Variable variable, const Term& term) const {
    const Term walked = Walk(term);
    if (walked.is_variable()) return walked.variable() == variable;
    return std::ranges::any_of(walked.arguments(),
                               [&](const Term& part) { return Occurs(variable, part); });
  }

  bool IsComputed(const Term& term) const {
    return term.kind() == Term::Kind::kCompound &&
           arithmetic_.FindFunction(term.symbol(), term.arguments().size()).has_value();
  }

  Term Instance(const Term& term) const {
    Term walked = Walk(term);
    if (walked.kind() != Term::Kind::kCompound) return walked;
    std::vector<Term> arguments;
    for (const Term& argument : walked.arguments()) arguments.push_back(Instance(argument));
    Term instance = Term::Compound(walked.symbol(), std::move(arguments));
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
    if (++visits_ > kMaxVisits) return true;
    if (next == steps_.size()) return ConcludesTarget();
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

  /// Arguments of the head that are computed are known only now.
  bool ConcludesTarget() {
    for (std::size_t i = 0; i < target_.arity(); ++i) {
      if (!Unify(head_->argument(i), target_.argument(i))) return false;
    }
    return true;
  }

  bool VisitFacts(std::size_t next, const Step& step, const Literal& literal) {
    const std::vector<std::optional<Term>> before = values_;
    const std::uint32_t rows = evaluator_.table(step.relation).size();
    for (std::uint32_t row = 0; row < rows; ++row) {
      const logic::Fact fact = evaluator_.FactOf({static_cast<std::uint32_t>(step.relation), row});
      bool matches = true;
      for (std::size_t i = 0; i < fact.arity() && matches; ++i) {
        matches = Unify(literal.atom.argument(i), fact.argument(i));
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
      return Unify(atom.argument(0), atom.argument(1));
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
  const logic::Atom* head_ = nullptr;
  logic::Atom target_;
  std::vector<std::optional<Term>> values_;  ///< Of the clause's variables, then the target's.
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

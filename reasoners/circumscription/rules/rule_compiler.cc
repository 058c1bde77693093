// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/rules/rule_compiler.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace latchwork::circumscription {

using logic::Term;

std::optional<Rule> RuleCompiler::Compile(std::span<const UsedLiteral> literals,
                                          std::span<const std::string> variables,
                                          std::string& problem) {
  rule_ = {};
  rule_.variables = variables.size();
  names_ = variables;
  pending_.clear();
  for (std::size_t i = 0; i < literals.size(); ++i) AddBody(literals[i], i);
  bound_.assign(rule_.variables, false);
  if (!Order(problem)) return std::nullopt;
  for (std::size_t i = 0; i < literals.size(); ++i) {
    if (!AddRest(literals[i], i, problem)) return std::nullopt;
  }
  return std::move(rule_);
}

void RuleCompiler::AddBody(const UsedLiteral& used, std::size_t index) {
  if (used.use != Use::kBody && used.use != Use::kAbsent) return;
  const logic::Atom& atom = used.literal->atom;
  if (atom.predicate() == equality_ && atom.arity() == 2) return AddEquation(*used.literal, index);
  Pending pending;
  pending.literal = index;
  pending.terms.assign(atom.arguments().begin(), atom.arguments().end());
  if (const auto test = arithmetic_.FindPredicate(atom.predicate(), atom.arity())) {
    pending.kind = Step::Kind::kTest;
    pending.test = *test;
    pending.negated = used.literal->positive;
    pending_.push_back(std::move(pending));
    return;
  }
  pending.relation = relations_.Of(NameOf(atom));
  if (used.use == Use::kAbsent) {
    pending.kind = Step::Kind::kAbsent;
  } else {
    if (relations_.IsAttachment(pending.relation)) pending.kind = Step::Kind::kCall;
    for (Term& term : pending.terms) {
      if (pending.kind == Step::Kind::kJoin) term = Flatten(term);
    }
  }
  pending_.push_back(std::move(pending));
}

void RuleCompiler::AddEquation(const logic::Literal& literal, std::size_t index) {
  Pending pending;
  pending.kind = Step::Kind::kEqual;
  pending.negated = literal.positive;
  pending.terms = {literal.atom.argument(0), literal.atom.argument(1)};
  pending.literal = index;
  pending_.push_back(std::move(pending));
}

/// The term with its arithmetic put into equations of its own.
Term RuleCompiler::Flatten(const Term& term) {
  if (term.kind() != Term::Kind::kCompound) return term;
  if (arithmetic_.FindFunction(term.symbol(), term.arguments().size())) {
    Term variable = Term::Var(static_cast<logic::Variable>(rule_.variables++));
    Pending pending;
    pending.kind = Step::Kind::kEqual;
    pending.terms = {term, variable};
    pending_.push_back(std::move(pending));
    return variable;
  }
  std::vector<Term> arguments;
  for (const Term& argument : term.arguments()) arguments.push_back(Flatten(argument));
  return Term::Compound(term.symbol(), std::move(arguments));
}

bool RuleCompiler::IsBound(const Term& term) const {
  if (term.is_variable()) return bound_[term.variable()];
  const auto arguments = term.arguments();
  return std::all_of(arguments.begin(), arguments.end(),
                     [&](const Term& argument) { return IsBound(argument); });
}

bool RuleCompiler::IsComputed(const Term& term) const {
  if (term.kind() != Term::Kind::kCompound) return false;
  const auto arguments = term.arguments();
  return arithmetic_.FindFunction(term.symbol(), arguments.size()).has_value() ||
         std::any_of(arguments.begin(), arguments.end(),
                     [&](const Term& argument) { return IsComputed(argument); });
}

bool RuleCompiler::IsReady(const Pending& pending) const {
  const auto bound = [&](const Term& term) { return IsBound(term); };
  switch (pending.kind) {
    case Step::Kind::kJoin:
      return true;
    case Step::Kind::kCall: {
      const sdk::Attachment& code = relations_.attachment(relations_[pending.relation].attachment);
      const auto& arguments = code.signature().arguments;
      for (std::size_t i = 0; i < arguments.size(); ++i) {
        const bool is_given = arguments[i].mode == sdk::Attachment::Mode::kIn;
        if ((is_given || IsComputed(pending.terms[i])) && !IsBound(pending.terms[i])) return false;
      }
      return true;
    }
    case Step::Kind::kEqual: {
      const bool first = IsBound(pending.terms[0]);
      const bool second = IsBound(pending.terms[1]);
      if (pending.negated || (first && second)) return first && second;
      return (first && !IsComputed(pending.terms[1])) || (second && !IsComputed(pending.terms[0]));
    }
    default:
      return std::all_of(pending.terms.begin(), pending.terms.end(), bound);
  }
}

/// The greatest comes next: what only checks, then facts with many known arguments, then
/// attachments.
std::size_t RuleCompiler::Merit(const Pending& pending) const {
  if (pending.kind == Step::Kind::kCall) return 1;
  if (pending.kind != Step::Kind::kJoin) return 1000;
  return 2 +
         static_cast<std::size_t>(std::count_if(pending.terms.begin(), pending.terms.end(),
                                                [&](const Term& term) { return IsBound(term); }));
}

bool RuleCompiler::Order(std::string& problem) {
  bound_.assign(rule_.variables, false);
  while (!pending_.empty()) {
    std::size_t best = kNoIndex;
    for (std::size_t i = 0; i < pending_.size(); ++i) {
      if (!IsReady(pending_[i])) continue;
      if (best == kNoIndex || Merit(pending_[i]) > Merit(pending_[best])) best = i;
    }
    if (best == kNoIndex) {
      for (const Term& term : pending_.front().terms) {
        if (problem.empty()) problem = Unbound(term);
      }
      return false;
    }
    const Pending next = std::move(pending_[best]);
    pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(best));
    Emit(next);
  }
  return true;
}

void RuleCompiler::Emit(const Pending& pending) {
  Step step;
  step.kind = pending.kind;
  step.negated = pending.negated;
  step.relation = pending.relation;
  step.test = pending.test;
  step.literal = pending.literal;
  if (pending.kind == Step::Kind::kEqual) {
    EmitEquation(pending, step);
  } else if (pending.kind == Step::Kind::kJoin || pending.kind == Step::Kind::kCall) {
    ChooseLookup(pending, step);
    for (const Term& term : pending.terms) {
      step.arguments.push_back(IsComputed(term) ? Build(term) : Match(term));
    }
  } else {
    for (const Term& term : pending.terms) step.arguments.push_back(Build(term));
  }
  rule_.steps.push_back(std::move(step));
}

void RuleCompiler::EmitEquation(const Pending& pending, Step& step) {
  const std::size_t computed = IsBound(pending.terms[0]) ? 0 : 1;
  step.arguments.push_back(Build(pending.terms[computed]));
  const Term& other = pending.terms[1 - computed];
  step.arguments.push_back(IsBound(other) ? Build(other) : Match(other));
}

void RuleCompiler::ChooseLookup(const Pending& pending, Step& step) {
  for (std::size_t i = 0; i < pending.terms.size(); ++i) {
    if (!IsBound(pending.terms[i])) continue;
    step.lookup = i;
    relations_.Index(pending.relation, i);
    return;
  }
}

bool RuleCompiler::AddRest(const UsedLiteral& used, std::size_t index, std::string& problem) {
  if (used.use != Use::kHead && used.use != Use::kOpen) return true;
  Head head;
  head.literal = index;
  head.relation = relations_.Of(NameOf(used.literal->atom));
  for (const Term& term : used.literal->atom.arguments()) {
    if (!IsBound(term)) {
      problem = Unbound(term);
      return false;
    }
    head.arguments.push_back(Build(term));
  }
  (used.use == Use::kHead ? rule_.heads : rule_.open).push_back(std::move(head));
  return true;
}

std::string RuleCompiler::Unbound(const Term& term) const {
  if (term.is_variable()) {
    if (bound_[term.variable()]) return {};
    const std::size_t variable = term.variable();
    if (variable >= names_.size()) return "a term in arithmetic takes its value from nothing";
    return fmt::format("variable '{}' takes its values from no premise", names_[variable]);
  }
  for (const Term& argument : term.arguments()) {
    if (std::string problem = Unbound(argument); !problem.empty()) return problem;
  }
  return {};
}

Pattern RuleCompiler::Match(const Term& term) {
  Pattern pattern;
  switch (term.kind()) {
    case Term::Kind::kVariable:
      pattern.variable = term.variable();
      pattern.kind = bound_[term.variable()] ? Pattern::Kind::kRead : Pattern::Kind::kBind;
      bound_[term.variable()] = true;
      break;
    case Term::Kind::kCompound:
      pattern.kind = Pattern::Kind::kCompound;
      pattern.function = term.symbol();
      for (const Term& argument : term.arguments()) pattern.arguments.push_back(Match(argument));
      break;
    default:
      pattern.value = ValueBank().Of(term);
  }
  return pattern;
}

Pattern RuleCompiler::Build(const Term& term) const {
  Pattern pattern;
  if (term.is_variable()) {
    pattern.kind = Pattern::Kind::kRead;
    pattern.variable = term.variable();
  } else if (term.kind() != Term::Kind::kCompound) {
    pattern.value = ValueBank().Of(term);
  } else {
    const auto compute = arithmetic_.FindFunction(term.symbol(), term.arguments().size());
    pattern.kind = compute ? Pattern::Kind::kCompute : Pattern::Kind::kCompound;
    if (compute) pattern.compute = *compute;
    pattern.function = term.symbol();
    for (const Term& argument : term.arguments()) pattern.arguments.push_back(Build(argument));
  }
  return pattern;
}

}  // namespace latchwork::circumscription

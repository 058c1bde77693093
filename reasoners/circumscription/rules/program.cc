// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/rules/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <utility>

namespace latchwork::circumscription {

using logic::Literal;

Program::Program(Purpose purpose, const sdk::Body& body, logic::SymbolTable& symbols)
    : purpose_(purpose), arithmetic_(symbols), equality_(symbols.Intern("=")), symbols_(symbols) {
  for (const logic::PredicateName& input : body.inputs) relations_.Of(input);
  for (const logic::Fact& fact : body.facts) relations_.Of(NameOf(fact));
  for (const sdk::Minimized& minimized : body.minimized) {
    relations_[relations_.Of(minimized.predicate)].level = static_cast<int>(minimized.priority);
  }
  for (const logic::PredicateName& fixed : body.fixed) {
    relations_[relations_.Of(fixed)].is_fixed = true;
  }
  for (const auto& code : body.attachments) {
    const sdk::Attachment::Signature& signature = code->signature();
    relations_.DeclareAttachment({symbols.Intern(signature.predicate), signature.arguments.size()},
                                 code);
  }
}

logic::Diagnostics Program::Compile(std::vector<logic::Clause> clauses) {
  clauses_ = std::move(clauses);
  rules_.clear();
  logic::Diagnostics diagnostics;
  for (std::size_t i = 0; i < clauses_.size(); ++i) AddRule(i, diagnostics);
  is_demoted_.assign(rules_.size(), false);
  if (!diagnostics.empty()) return diagnostics;
  Stratify();
  CheckGrowth(diagnostics);
  return diagnostics;
}

bool Program::IsOrdinary(const Literal& literal) const {
  const logic::PredicateName name = NameOf(literal.atom);
  if (name.symbol == equality_ && name.arity == 2) return false;
  if (arithmetic_.FindPredicate(name.symbol, name.arity)) return false;
  const std::size_t relation = relations_.Find(name);
  return relation == kNoIndex || !relations_.IsAttachment(relation);
}

int Program::LevelOf(const Literal& literal) const {
  const std::size_t relation = relations_.Find(NameOf(literal.atom));
  return relation == kNoIndex ? 0 : relations_[relation].level;
}

/// The only literal that varies; where none does, the one that is minimized after all others.
const Literal* Program::ChooseHead(std::span<const Literal* const> positive) const {
  const Literal* head = nullptr;
  bool is_only = true;
  const auto order = [&](const Literal* literal) {
    const int level = LevelOf(*literal);
    return level == 0 ? INT_MAX : level;
  };
  for (const Literal* literal : positive) {
    if (head == nullptr || order(literal) > order(head)) {
      head = literal;
      is_only = true;
    } else if (order(literal) == order(head)) {
      is_only = false;
    }
  }
  return is_only ? head : nullptr;
}

std::vector<UsedLiteral> Program::UsesOf(const logic::Clause& clause) const {
  std::vector<const Literal*> positive;
  for (const Literal& literal : clause.literals) {
    if (literal.positive && IsOrdinary(literal)) positive.push_back(&literal);
  }
  const Literal* head = ChooseHead(positive);
  std::vector<UsedLiteral> uses;
  for (const Literal& literal : clause.literals) {
    Use use = Use::kBody;
    if (IsOrdinary(literal)) {
      const std::size_t relation = relations_.Find(NameOf(literal.atom));
      const bool is_fixed = relation != kNoIndex && relations_[relation].is_fixed;
      if (literal.positive) use = Use::kHead;
      if (literal.positive && purpose_ == Purpose::kCertificate && &literal != head) {
        use = Use::kAbsent;
      }
      if (is_fixed && purpose_ == Purpose::kGrounding) use = Use::kOpen;
    }
    uses.push_back({&literal, use});
  }
  return uses;
}

bool Program::AddRule(std::size_t clause, logic::Diagnostics& diagnostics) {
  const logic::Clause& source = clauses_[clause];
  std::string problem;
  const auto refuse = [&] {
    diagnostics.push_back({source.place,
                           fmt::format("'{}' cannot be grounded: {}", source.name, problem),
                           "exact circumscription needs premises that bind each variable; the mode "
                           "'bounded' does not",
                           ""});
    return false;
  };
  for (const Literal& literal : source.literals) {
    const std::size_t relation = relations_.Find(NameOf(literal.atom));
    if (!literal.positive || relation == kNoIndex || !relations_.IsAttachment(relation)) continue;
    problem = fmt::format("it concludes the attachment '{}'", literal.atom.predicate().name());
    return refuse();
  }
  RuleCompiler compiler(relations_, arithmetic_, equality_);
  std::optional<Rule> rule = compiler.Compile(UsesOf(source), source.variable_names, problem);
  if (!rule) return refuse();
  rule->clause = clause;
  rules_.push_back(*std::move(rule));
  return true;
}

std::optional<Rule> Program::CompileQuery(std::span<const Literal> query, std::size_t variables,
                                          std::size_t answers, std::string& problem) {
  std::vector<logic::Term> terms;
  for (std::size_t i = 0; i < variables; ++i) {
    terms.push_back(logic::Term::Var(static_cast<logic::Variable>(i)));
  }
  const Literal head{true, logic::Atom(relations_[answers].name.symbol, terms)};
  std::vector<Literal> complements;
  for (const Literal& literal : query) complements.push_back({!literal.positive, literal.atom});
  std::vector<UsedLiteral> uses;
  for (const Literal& literal : complements) {
    uses.push_back({&literal, literal.positive && IsOrdinary(literal) ? Use::kAbsent : Use::kBody});
  }
  uses.push_back({&head, Use::kHead});
  const std::vector<std::string> names(variables);
  return RuleCompiler(relations_, arithmetic_, equality_).Compile(uses, names, problem);
}

std::size_t Program::AddAnswers(std::size_t variables) {
  return relations_.Of({symbols_.Fresh("answers"), variables});
}

Dependencies Program::FindDependencies() const {
  Dependencies dependencies = questions_;
  for (std::size_t i = 0; i < rules_.size(); ++i) {
    if (is_demoted_[i]) continue;
    for (const Head& head : rules_[i].heads) {
      for (const Step& step : rules_[i].steps) {
        if (step.relation != kNoIndex) dependencies.emplace_back(step.relation, head.relation);
      }
    }
  }
  return dependencies;
}

void Program::Stratify() {
  do {
    const StrataOf found = FindStrata(relations_.size(), FindDependencies());
    for (std::size_t i = 0; i < relations_.size(); ++i) relations_[i].stratum = found.stratum[i];
    strata_.assign(std::max<std::size_t>(1, found.is_recursive.size()), {});
    for (std::size_t i = 0; i < found.is_recursive.size(); ++i) {
      strata_[i].is_recursive = found.is_recursive[i];
    }
  } while (DemoteUnstratified());
  Arrange();
}

/// A default whose atom is not decided before what rests on it is none: such rules only check.
bool Program::DemoteUnstratified() {
  bool found = false;
  for (std::size_t i = 0; i < rules_.size(); ++i) {
    Rule& rule = rules_[i];
    if (rule.heads.size() != 1 || is_demoted_[i] || purpose_ == Purpose::kGrounding) continue;
    const std::size_t stratum = relations_[rule.heads.front().relation].stratum;
    is_demoted_[i] = std::any_of(rule.steps.begin(), rule.steps.end(), [&](const Step& step) {
      return step.kind == Step::Kind::kAbsent && relations_[step.relation].stratum == stratum;
    });
    if (!is_demoted_[i]) continue;
    found = true;
    Step absent;
    absent.kind = Step::Kind::kAbsent;
    absent.relation = rule.heads.front().relation;
    absent.arguments = rule.heads.front().arguments;
    absent.literal = rule.heads.front().literal;
    rule.steps.push_back(std::move(absent));
    rule.heads.clear();
  }
  return found;
}

/// Rules go to the first stratum in which they conclude something; constraints to the end, or in
/// grounding, where what attachments ask for heeds them, to the first stratum after which they can
/// be looked at.
void Program::Arrange() {
  constraints_.clear();
  for (std::size_t i = 0; i < rules_.size(); ++i) {
    Rule& rule = rules_[i];
    std::size_t stratum = kNoIndex;
    for (const Head& head : rule.heads) {
      stratum = std::min(stratum, relations_[head.relation].stratum);
      relations_[head.relation].is_concluded = true;
    }
    rule.ordinals = 0;
    for (Step& step : rule.steps) {
      const bool is_own = step.kind == Step::Kind::kJoin && stratum != kNoIndex &&
                          relations_[step.relation].stratum == stratum;
      step.ordinal = is_own ? rule.ordinals++ : kNoIndex;
    }
    if (stratum != kNoIndex) {
      strata_[stratum].rules.push_back(i);
    } else if (purpose_ == Purpose::kCertificate) {
      constraints_.push_back(i);
    } else {
      strata_[LastStratumOf(rule)].checks.push_back(i);
    }
  }
}

std::size_t Program::LastStratumOf(const Rule& rule) const {
  std::size_t last = 0;
  for (const Step& step : rule.steps) {
    if (step.relation != kNoIndex) last = std::max(last, relations_[step.relation].stratum);
  }
  return last;
}

namespace {

bool MakesTerms(const Pattern& pattern) {
  return pattern.kind == Pattern::Kind::kCompound || pattern.kind == Pattern::Kind::kCompute;
}

bool MakesTerms(const Rule& rule) {
  for (const Step& step : rule.steps) {
    if (step.kind == Step::Kind::kEqual && !step.negated && MakesTerms(step.arguments[0])) {
      return true;
    }
    if (step.kind == Step::Kind::kCall &&
        std::any_of(step.arguments.begin(), step.arguments.end(), [](const Pattern& argument) {
          return argument.kind == Pattern::Kind::kBind;
        })) {
      return true;
    }
  }
  return std::any_of(rule.heads.begin(), rule.heads.end(), [](const Head& head) {
    return std::any_of(head.arguments.begin(), head.arguments.end(),
                       [](const Pattern& argument) { return MakesTerms(argument); });
  });
}

}  // namespace

/// What recursion makes of terms of its own may have no end.
void Program::CheckGrowth(logic::Diagnostics& diagnostics) const {
  for (const Rule& rule : rules_) {
    if (rule.ordinals == 0 || !MakesTerms(rule)) continue;
    const logic::Clause& clause = clauses_[rule.clause];
    diagnostics.push_back(
        {clause.place,
         fmt::format("'{}' cannot be grounded: it is recursive and makes new terms, so that there "
                     "may be no end of its instances",
                     clause.name),
         "the mode 'bounded' searches such rules to a depth", ""});
  }
}

bool Program::AddQuestion(std::size_t attachment, std::size_t relation) {
  const std::pair<std::size_t, std::size_t> question{relation, attachment};
  if (std::find(questions_.begin(), questions_.end(), question) != questions_.end()) return false;
  questions_.push_back(question);
  return true;
}

std::string Program::CircularAttachment() const {
  for (std::size_t i = 0; i < relations_.size(); ++i) {
    if (relations_.IsAttachment(i) && strata_[relations_[i].stratum].is_recursive) {
      return std::string(relations_[i].name.symbol.name());
    }
  }
  return {};
}

}  // namespace latchwork::circumscription

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/eprover/eprover_reasoner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>

#include "core/process/spawn.h"
#include "latchwork/logic/arithmetic.h"
#include "latchwork/sdk/specs.h"
#include "reasoners/eprover/disguise.h"

namespace latchwork::eprover {
namespace {

constexpr std::size_t kNoPort = SIZE_MAX;
constexpr std::size_t kMostInstances = 10000;
constexpr std::size_t kAllAnswers = 1'000'000;

bool HasArithmetic(const logic::Term& term, const logic::Arithmetic& arithmetic) {
  if (term.arguments().empty()) return false;
  return arithmetic.FindFunction(term.symbol(), term.arguments().size()).has_value() ||
         std::ranges::any_of(term.arguments(), [&](const logic::Term& argument) {
           return HasArithmetic(argument, arithmetic);
         });
}

bool IsDenial(const logic::Clause& clause) {
  return std::ranges::none_of(clause.literals,
                              [](const logic::Literal& literal) { return literal.positive; });
}

bool Matches(const logic::Term& pattern, const logic::Term& term,
             std::map<logic::Variable, logic::Term>& values) {
  if (pattern.is_variable()) {
    return values.emplace(pattern.variable(), term).first->second == term;
  }
  const auto parts = pattern.arguments();
  if (parts.empty()) return pattern == term;
  if (term.arguments().size() != parts.size() || term.symbol() != pattern.symbol()) return false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!Matches(parts[i], term.arguments()[i], values)) return false;
  }
  return true;
}

bool Matches(const logic::Atom& pattern, const logic::Fact& fact) {
  std::map<logic::Variable, logic::Term> values;
  if (NameOf(pattern) != NameOf(fact)) return false;
  for (std::size_t i = 0; i < fact.arity(); ++i) {
    if (!Matches(pattern.argument(i), fact.argument(i), values)) return false;
  }
  return true;
}

}  // namespace

std::span<const sdk::ParameterSpec> EproverReasoner::parameters() const {
  static const std::array<sdk::ParameterSpec, 5> kTable = {
      sdk::BooleanParameter("cache_decisions", true,
                            "what was decided stands while the latches hold the same"),
      sdk::ChoiceParameter("heuristic",
                           {"Auto", "AutoSched0", "AutoSched1", "AutoSched2", "AutoSched3"},
                           "how E chooses clauses (its option -x)"),
      sdk::IntegerParameter("clauses", "2000", 1, 1e9,
                            "clauses that E may process for one question, if the budget of "
                            "inferences is no smaller"),
      sdk::RealParameter("seconds", "10", 0.01, 86400, "s",
                         "wall time after which a question is broken off; what was decided then "
                         "depends on the machine"),
      sdk::IntegerParameter("memory", "1024", 64, 16777216, "memory that E may use", "MB")};
  return kTable;
}

logic::Diagnostics EproverReasoner::Load(const sdk::Body& body, const sdk::Parameters& parameters,
                                         logic::SymbolTable& symbols) {
  body_ = body;
  symbols_ = &symbols;
  program_ = process::FindProgram("eprover");
  if (program_.empty()) {
    return {{{},
             "reasoner eprover: there is no program 'eprover' in PATH",
             "install it: sudo apt-get install --no-install-recommends eprover",
             ""}};
  }
  cache_decisions_ = parameters.Boolean("cache_decisions");
  limits_.heuristic = parameters.Text("heuristic");
  most_clauses_ = static_cast<std::uint64_t>(parameters.Integer("clauses"));
  limits_.seconds = parameters.Real("seconds");
  limits_.memory_mb = static_cast<std::uint64_t>(parameters.Integer("memory"));
  theory_ = std::make_unique<pttp::Theory>(body_, symbols);
  if (auto diagnostics = theory_->ReadFiles(); !diagnostics.empty()) return diagnostics;
  return Compile();
}

logic::Diagnostics EproverReasoner::CheckFragment() const {
  logic::Diagnostics diagnostics;
  const logic::Arithmetic arithmetic(*symbols_);
  const auto refuse = [&](const logic::Clause& clause, std::string_view what) {
    diagnostics.push_back(
        {clause.place,
         fmt::format("reasoner eprover: '{}' has {}, of which E has no theory", clause.name, what),
         "reasoners pttp, circumscription and swipl take it", ""});
  };
  for (const logic::Clause& clause : clauses_) {
    const bool computes = std::ranges::any_of(clause.literals, [&](const auto& literal) {
      const logic::Atom& atom = literal.atom;
      return arithmetic.FindPredicate(atom.predicate(), atom.arity()).has_value() ||
             std::ranges::any_of(atom.arguments(), [&](const logic::Term& argument) {
               return HasArithmetic(argument, arithmetic);
             });
    });
    if (computes) refuse(clause, "arithmetic");
  }
  for (const auto& attachment : body_.attachments) {
    const std::string& name = attachment->signature().predicate;
    for (const logic::Clause& clause : clauses_) {
      const bool calls = std::ranges::any_of(clause.literals, [&](const auto& literal) {
        return literal.atom.predicate().name() == name;
      });
      if (calls) refuse(clause, fmt::format("the attachment {}", name));
    }
  }
  return diagnostics;
}

logic::Diagnostics EproverReasoner::Compile() {
  decided_ = false;
  clauses_ = theory_->Clauses(false);
  if (auto diagnostics = CheckFragment(); !diagnostics.empty()) return diagnostics;
  closings_ = Closings(body_, clauses_, *symbols_);
  if (!closings_.obstacle().empty()) {
    return {{closings_.place(), fmt::format("reasoner eprover: {}", closings_.obstacle()),
             "reasoners pttp, circumscription and swipl decide such defaults one by one", ""}};
  }
  axioms_.clear();
  has_denials_ = false;
  for (const logic::Clause& clause : clauses_) {
    axioms_ += Axiom(clause);
    has_denials_ = has_denials_ || IsDenial(clause);
  }
  return {};
}

logic::Diagnostics EproverReasoner::Change(
    const std::function<logic::Diagnostics(pttp::Theory&)>& change) {
  const pttp::Theory before = *theory_;
  auto diagnostics = change(*theory_);
  if (diagnostics.empty()) diagnostics = Compile();
  if (diagnostics.empty()) return {};
  *theory_ = before;
  Compile();
  return diagnostics;
}

logic::Diagnostics EproverReasoner::Tell(std::string_view text) {
  return Change([&](pttp::Theory& theory) { return theory.Tell(text); });
}

logic::Diagnostics EproverReasoner::Retract(std::string_view name) {
  return Change([&](pttp::Theory& theory) { return theory.Retract(name); });
}

void EproverReasoner::Collect(std::span<const sdk::Latch> latches, std::size_t without) {
  facts_ = body_.facts;
  for (std::size_t i = 0; i < latches.size(); ++i) {
    if (i == without) continue;
    facts_.insert(facts_.end(), latches[i].facts.begin(), latches[i].facts.end());
  }
}

std::string EproverReasoner::AxiomsOf(std::span<const logic::Fact> facts) const {
  std::string axioms = axioms_;
  for (const logic::Fact& fact : facts) axioms += Axiom(logic::Literal{true, fact});
  return axioms;
}

bool EproverReasoner::Heed(const Reply& reply, sdk::Decision& decision) {
  decision.statistics.inferences += reply.processed;
  switch (reply.end) {
    case Reply::End::kTime:
      decision.limit = sdk::Limit::kTime;
      return false;
    case Reply::End::kCancelled:
      decision.limit = sdk::Limit::kCancelled;
      return false;
    case Reply::End::kFailed:
      decision.status = sdk::Status::kFailed;
      decision.message = reply.problem;
      return false;
    default:
      return true;
  }
}

Reply EproverReasoner::Ask(const std::string& axioms, const logic::Atom* pattern,
                           std::size_t answers, sdk::Decision& decision) {
  Reply reply = eprover::Ask(program_, axioms, pattern, answers, limits_, *symbols_);
  if (!Heed(reply, decision)) return reply;
  if (reply.end == Reply::End::kContradiction && pattern != nullptr) {
    decision.message = "the defaults contradict each other";
  }
  return reply;
}

bool EproverReasoner::CheckConsistency(const std::string& axioms, sdk::Decision& decision) {
  if (!has_denials_) return true;
  const Reply reply = Ask(axioms, nullptr, 1, decision);
  if (reply.end == Reply::End::kContradiction) {
    decision.status = sdk::Status::kInconsistent;
    decision.message = "body and latches contradict each other";
    return false;
  }
  return decision.limit == sdk::Limit::kNone && decision.status != sdk::Status::kFailed;
}

bool EproverReasoner::Close(const Closings::Closing& closing, std::string& axioms,
                            sdk::Decision& decision) {
  using State = sdk::Assumption::State;
  const auto instances = closings_.Instances(closing.predicate, facts_, kMostInstances);
  if (!instances) {
    decision.message = fmt::format("{} may hold of too many terms", ToString(closing.predicate));
    return false;
  }
  std::vector<logic::Atom> proved;
  State unproved = State::kMade;
  if (closing.has_rules && !instances->empty()) {
    std::vector<logic::Term> variables;
    for (std::size_t i = 0; i < closing.predicate.arity; ++i) {
      variables.push_back(logic::Term::Var(static_cast<logic::Variable>(i)));
    }
    const logic::Atom pattern(closing.predicate.symbol, variables);
    const std::size_t wanted = variables.empty() ? 1 : kAllAnswers;
    const Reply reply = Ask(axioms, &pattern, wanted, decision);
    if (!decision.message.empty() || decision.limit != sdk::Limit::kNone) return false;
    proved = reply.answers;
    if (reply.end == Reply::End::kClauses) unproved = State::kMadeByBound;
  } else {
    std::ranges::copy_if(facts_, std::back_inserter(proved), [&](const logic::Fact& fact) {
      return NameOf(fact) == closing.predicate;
    });
    for (const logic::Clause& clause : clauses_) {
      if (clause.literals.size() == 1 && clause.literals[0].positive) {
        proved.push_back(clause.literals[0].atom);
      }
    }
  }
  for (const logic::Fact& instance : *instances) {
    const bool holds = std::ranges::any_of(
        proved, [&](const logic::Atom& pattern) { return Matches(pattern, instance); });
    decision.assumptions.push_back({instance, holds ? State::kRetracted : unproved});
    if (!holds) axioms += Axiom(logic::Literal{false, instance});
  }
  return true;
}

bool EproverReasoner::AnswerGoal(std::size_t goal, const std::string& axioms,
                                 sdk::Decision& decision) {
  const bool all = body_.goals[goal].answers == sdk::Goal::Answers::kAll;
  const logic::Atom& pattern = body_.goals[goal].pattern;
  const Reply reply =
      Ask(axioms, &pattern, all && !pattern.is_ground() ? kAllAnswers : 1, decision);
  if (!decision.message.empty() || decision.status == sdk::Status::kFailed) return false;
  for (const logic::Atom& answer : reply.answers) {
    if (answer.is_ground()) {
      decision.conclusions.push_back({goal, answer, {}});
    } else {
      decision.message =
          fmt::format("{} was proved for every value, which is no fact", ToString(answer));
    }
  }
  if (reply.end == Reply::End::kClauses) decision.limit = sdk::Limit::kInferences;
  return decision.limit == sdk::Limit::kNone;
}

void EproverReasoner::DecideAnew(sdk::Decision& decision) {
  std::string axioms = AxiomsOf(facts_);
  if (!CheckConsistency(axioms, decision)) return;
  for (const auto& closing : closings_.order()) {
    if (!Close(closing, axioms, decision)) return;
  }
  bool is_decided = true;
  for (std::size_t i = 0; i < body_.goals.size(); ++i) {
    const bool goes_on = AnswerGoal(i, axioms, decision);
    is_decided = is_decided && goes_on;
    const bool is_over = decision.limit == sdk::Limit::kTime ||
                         decision.limit == sdk::Limit::kCancelled ||
                         decision.status == sdk::Status::kFailed;
    if (is_over) return;
  }
  if (!is_decided) return;
  decision.status = decision.conclusions.empty() ? sdk::Status::kRefuted : sdk::Status::kProved;
}

bool EproverReasoner::IsUnchanged(std::span<const sdk::Latch> latches, const sdk::Budget& budget) {
  bool same = decided_ && cache_decisions_ && versions_.size() == latches.size() &&
              budget.inferences == last_budget_.inferences;
  versions_.resize(latches.size());
  for (std::size_t i = 0; i < latches.size(); ++i) {
    same = same && versions_[i] == latches[i].version;
    versions_[i] = latches[i].version;
  }
  last_budget_ = budget;
  return same;
}

void EproverReasoner::Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                             sdk::Decision& decision) {
  if (IsUnchanged(latches, budget)) {
    decision = last_;
    return;
  }
  decision.Clear();
  decision.status = sdk::Status::kUnknown;
  limits_.clauses = std::min(most_clauses_, std::max<std::uint64_t>(1, budget.inferences));
  limits_.deadline = budget.deadline;
  limits_.cancelled = budget.cancelled;
  Collect(latches, kNoPort);
  DecideAnew(decision);
  last_ = decision;
  last_.statistics = {};
  decided_ = decision.status != sdk::Status::kFailed && decision.limit != sdk::Limit::kTime &&
             decision.limit != sdk::Limit::kCancelled;
}

void EproverReasoner::Admit(std::span<const sdk::Latch> latches, std::size_t port,
                            std::span<const logic::Fact> batch, const sdk::Budget& budget,
                            std::vector<sdk::Refusal>& refused) {
  if (!has_denials_) return;
  limits_.clauses = std::min(most_clauses_, std::max<std::uint64_t>(1, budget.inferences));
  limits_.deadline = budget.deadline;
  limits_.cancelled = budget.cancelled;
  Collect(latches, port);
  // Together first: most batches offend nothing.
  const auto contradicts = [&](std::span<const logic::Fact> facts) {
    return eprover::Ask(program_, AxiomsOf(facts), nullptr, 1, limits_, *symbols_).end ==
           Reply::End::kContradiction;
  };
  std::vector<logic::Fact> together = facts_;
  together.insert(together.end(), batch.begin(), batch.end());
  if (!contradicts(together)) return;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    facts_.push_back(batch[i]);
    if (!contradicts(facts_)) continue;
    facts_.pop_back();
    refused.push_back({i, "contradicts the body and what the latches hold"});
  }
}

sdk::Derivation EproverReasoner::Explain(std::size_t /*conclusion*/) { return {}; }

}  // namespace latchwork::eprover

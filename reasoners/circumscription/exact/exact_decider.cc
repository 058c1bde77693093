// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/exact/exact_decider.h"

#include <algorithm>
#include <utility>

#include "reasoners/circumscription/exact/derivation.h"
#include "reasoners/circumscription/explanation/match.h"
#include "reasoners/circumscription/explanation/near_miss.h"

namespace latchwork::circumscription {

ExactDecider::ExactDecider(const sdk::Body& body, logic::SymbolTable& symbols, bool is_brave)
    : body_(body),
      symbols_(symbols),
      program_(Program::Purpose::kCertificate, body, symbols),
      evaluator_(program_),
      search_(body, symbols, is_brave),
      must_search_(is_brave || !body.fixed.empty()) {}

logic::Diagnostics ExactDecider::Compile(std::vector<logic::Clause> clauses) {
  logic::Diagnostics diagnostics = search_.Compile(clauses);
  if (!diagnostics.empty()) return diagnostics;
  diagnostics = program_.Compile(std::move(clauses));
  if (diagnostics.empty() && goals_.empty()) goals_ = CompileGoals(body_, program_, diagnostics);
  return diagnostics;
}

bool ExactDecider::Search(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                          sdk::Decision& decision) {
  searched_ = true;
  const bool is_decided = search_.Decide(latches, budget, decision);
  if (!is_decided) reason_ = search_.reason();
  return is_decided;
}

/// What the certificate took is a part of what the decision spends.
bool ExactDecider::SearchWithRest(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                                  sdk::Decision& decision) {
  const Spending& spent = evaluator_.spending();
  sdk::Budget rest = budget;
  rest.inferences -= std::min(rest.inferences, spent.inferences());
  if (!Search(latches, rest, decision)) return false;
  decision.statistics.inferences += spent.inferences();
  decision.statistics.attachment_calls += spent.attachment_calls;
  return true;
}

bool ExactDecider::Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                          sdk::Decision& decision) {
  if (must_search_) return Search(latches, budget, decision);
  ports_.resize(latches.size());
  for (std::size_t i = 0; i < latches.size(); ++i) ports_[i] = latches[i].port;
  const Evaluator::End end = evaluator_.Run(body_.facts, latches, budget);
  searched_ = false;
  has_model_ = end == Evaluator::End::kModel;
  if (end == Evaluator::End::kRefused) {
    reason_ = evaluator_.refusal();
    return false;
  }
  // Search finds the least core of a contradiction, too.
  if (end == Evaluator::End::kOpen || end == Evaluator::End::kInconsistent) {
    return SearchWithRest(latches, budget, decision);
  }
  Fill(decision);
  return true;
}

void ExactDecider::Fill(sdk::Decision& decision) {
  decision.message.clear();
  decision.statistics = {};
  decision.undecided.clear();
  decision.states.clear();
  decision.status = sdk::Status::kUnknown;
  conclusions_.clear();
  if (has_model_) AnswerGoals(decision);
  decision.limit = evaluator_.spending().limit();
  decision.conclusions.resize(conclusions_.size());
  ListAssumptions(decision);
  decision.statistics.inferences = evaluator_.spending().inferences();
  decision.statistics.attachment_calls = evaluator_.spending().attachment_calls;
}

void ExactDecider::AnswerGoals(sdk::Decision& decision) {
  for (std::size_t goal = 0; goal < goals_.size(); ++goal) {
    const CompiledGoal& compiled = goals_[goal];
    evaluator_.Answer(compiled.rule);
    const FactTable& answers = evaluator_.table(compiled.answers);
    const bool first_only = body_.goals[goal].answers == sdk::Goal::Answers::kFirst;
    const std::uint32_t wanted = first_only ? std::min(1U, answers.size()) : answers.size();
    for (std::uint32_t row = 0; row < wanted; ++row) {
      const std::size_t next = conclusions_.size();
      if (next == decision.conclusions.size()) decision.conclusions.emplace_back();
      ListConclusion(goal, row, decision.conclusions[next]);
      decision.statistics.depth = std::max(decision.statistics.depth, answers.info(row).height);
    }
  }
  if (evaluator_.spending().is_spent()) return;
  decision.status = conclusions_.empty() ? sdk::Status::kRefuted : sdk::Status::kProved;
}

void ExactDecider::ListConclusion(std::size_t goal, std::uint32_t row,
                                  sdk::Conclusion& conclusion) {
  const FactInfo& info = evaluator_.table(goals_[goal].answers).info(row);
  const FactRef fact = evaluator_.Premises(info).front();
  conclusions_.push_back(fact);
  conclusion.goal = goal;
  conclusion.fact = evaluator_.FactOf(fact);
  conclusion.assumptions.clear();
  Collect(info, conclusion.assumptions);
}

/// The defaults behind a fact, each once, in the order in which they were asked for.
void ExactDecider::Collect(const FactInfo& info, std::vector<std::size_t>& assumptions) {
  if (info.rank == 0) return;
  const auto premises = evaluator_.Premises(info);
  open_.assign(premises.begin(), premises.end());
  for (std::size_t i = 0; i < open_.size(); ++i) {
    const FactRef fact = open_[i];
    if (fact.relation == FactRef::kAssumption) {
      assumptions.push_back(fact.row);
      continue;
    }
    const FactInfo& next = evaluator_.InfoOf(fact);
    if (next.rank == 0) continue;
    for (const FactRef premise : evaluator_.Premises(next)) {
      if (std::find(open_.begin(), open_.end(), premise) == open_.end()) open_.push_back(premise);
    }
  }
  std::sort(assumptions.begin(), assumptions.end());
  assumptions.erase(std::unique(assumptions.begin(), assumptions.end()), assumptions.end());
}

void ExactDecider::ListAssumptions(sdk::Decision& decision) const {
  const auto defaults = evaluator_.defaults();
  decision.assumptions.resize(defaults.size());
  for (std::size_t i = 0; i < defaults.size(); ++i) {
    sdk::Assumption& assumption = decision.assumptions[i];
    assumption.atom = evaluator_.DefaultAtom(defaults[i]);
    assumption.state = defaults[i].contrary == FactTable::kNone
                           ? sdk::Assumption::State::kMade
                           : sdk::Assumption::State::kRetracted;
  }
}

std::optional<sdk::Explanation> ExactDecider::ExplainAssumption(std::size_t assumption) const {
  if (searched_) return search_.ExplainAssumption(assumption);
  const auto defaults = evaluator_.defaults();
  if (assumption >= defaults.size()) return std::nullopt;
  const AskedDefault& asked = defaults[assumption];
  const logic::Fact atom = evaluator_.DefaultAtom(asked);
  sdk::Explanation explanation{ToString(atom), asked.contrary != FactTable::kNone, {}, {}};
  if (explanation.holds) {
    explanation.derivation = DeriveFact(evaluator_, {asked.relation, asked.contrary}, ports_);
  } else if (has_model_) {
    explanation.misses = NearMissesOf(atom, evaluator_, symbols_);
  } else {
    return std::nullopt;
  }
  return explanation;
}

/// A conclusion if there is one, or what else holds: goals may want no more than their first.
std::optional<FactRef> ExactDecider::FindInstance(const logic::Atom& pattern) const {
  for (const FactRef fact : conclusions_) {
    if (Matches(pattern, evaluator_.FactOf(fact))) return fact;
  }
  const std::size_t relation = program_.relations().Find(NameOf(pattern));
  if (relation == kNoIndex) return std::nullopt;
  for (std::uint32_t row = 0; row < evaluator_.table(relation).size(); ++row) {
    const FactRef fact{static_cast<std::uint32_t>(relation), row};
    if (Matches(pattern, evaluator_.FactOf(fact))) return fact;
  }
  return std::nullopt;
}

std::optional<sdk::Explanation> ExactDecider::WhyNot(const sdk::Decision& decision,
                                                     const logic::Atom& pattern) const {
  if (searched_) return search_.WhyNot(decision, pattern);
  if (!has_model_) return std::nullopt;
  const auto instance = FindInstance(pattern);
  sdk::Explanation explanation{ToString(pattern), instance.has_value(), {}, {}};
  if (instance) {
    explanation.derivation = DeriveFact(evaluator_, *instance, ports_);
  } else {
    explanation.misses = NearMissesOf(pattern, evaluator_, symbols_);
  }
  return explanation;
}

sdk::Derivation ExactDecider::Explain(const sdk::Decision& decision, std::size_t conclusion) const {
  if (searched_) return search_.Explain(decision, conclusion);
  if (conclusion >= conclusions_.size() || conclusion >= decision.conclusions.size()) return {};
  return DeriveFact(evaluator_, conclusions_[conclusion], ports_);
}

}  // namespace latchwork::circumscription

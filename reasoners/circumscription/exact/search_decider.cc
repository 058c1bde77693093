// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/exact/search_decider.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "reasoners/circumscription/exact/search_reasons.h"
#include "reasoners/circumscription/explanation/match.h"
#include "reasoners/circumscription/explanation/near_miss.h"

namespace latchwork::circumscription {
namespace {

// Of explanations, which have no budget.
constexpr int kConflicts = 100'000;
constexpr std::size_t kCalls = 10'000;
constexpr std::size_t kMaxTerms = 1U << 16U;
// Instances of earlier cycles are kept while they are not many more than those of this one.
constexpr std::size_t kKept = 4;
constexpr std::size_t kAlwaysKept = 2000;
// Joint states are listed for no more undecided instances than these.
constexpr std::size_t kMaxJoint = 6;

EngineOptions Limits() {
  EngineOptions options;
  options.conflicts = kConflicts;
  options.calls = kCalls;
  return options;
}

/// The budget of the decision is the only limit.
EngineOptions ChargedTo(Spending& spending) {
  EngineOptions options;
  options.calls = std::numeric_limits<std::size_t>::max();
  options.spending = &spending;
  return options;
}

}  // namespace

SearchDecider::SearchDecider(const sdk::Body& body, logic::SymbolTable& symbols, bool is_brave)
    : body_(body),
      symbols_(symbols),
      is_brave_(is_brave),
      program_(Program::Purpose::kGrounding, body, symbols),
      evaluator_(program_, this),
      store_(program_.relations()) {}

logic::Diagnostics SearchDecider::Compile(std::vector<logic::Clause> clauses) {
  logic::Diagnostics diagnostics = program_.Compile(std::move(clauses));
  if (goals_.empty()) goals_ = CompileGoals(body_, program_, diagnostics);
  return diagnostics;
}

void SearchDecider::Instance(std::size_t clause, std::span<const Literal> literals) {
  ++instances_;
  store_.Add(clause, literals);
}

Evaluator::End SearchDecider::Ground(std::span<const sdk::Latch> latches,
                                     const sdk::Budget& budget) {
  const bool is_full = store_.size() > kAlwaysKept && store_.size() > kKept * instances_;
  if (is_full || evaluator_.terms() > kMaxTerms) {
    engine_.reset();
    store_.Clear();
    evaluator_.ForgetTerms();
  }
  instances_ = 0;
  store_.BeginGiven();
  return evaluator_.Run(body_.facts, latches, budget);
}

/// Lets the engine stand for the store and for what is given now.
void SearchDecider::Prepare() {
  const std::size_t atoms = store_.theory().atoms.size();
  if (!engine_ || prepared_ != store_.size() || prepared_atoms_ != atoms) {
    engine_ = std::make_unique<Engine>(store_.theory(), ChargedTo(evaluator_.spending()));
    prepared_ = store_.size();
    prepared_atoms_ = atoms;
  }
  latches_ = store_.Latches();
  engine_->SetLatches(latches_);
}

bool SearchDecider::IsCertain(std::span<const Literal> literals) {
  if (literals.empty()) return true;
  Prepare();
  return std::all_of(literals.begin(), literals.end(), [&](Literal literal) {
    return engine_->EntailsAlways({&literal, 1}).verdict == Verdict::kYes;
  });
}

bool SearchDecider::Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                           sdk::Decision& decision) {
  ports_.resize(latches.size());
  for (std::size_t i = 0; i < latches.size(); ++i) ports_[i] = latches[i].port;
  Forget();
  const Evaluator::End end = Ground(latches, budget);
  if (end == Evaluator::End::kRefused) return false;
  decision.Clear();
  decision.status = sdk::Status::kUnknown;
  if (end != Evaluator::End::kSpent) Answer(decision);
  const Spending& spending = evaluator_.spending();
  decision.limit = spending.limit();
  decision.statistics.inferences = spending.inferences();
  decision.statistics.attachment_calls = spending.attachment_calls;
  return true;
}

/// Nothing of an earlier cycle explains one whose grounding does not come to its end.
void SearchDecider::Forget() {
  latches_.clear();
  assumed_.clear();
  made_.clear();
  concluded_.clear();
  undecided_.clear();
  is_unknown_ = false;
  is_answered_ = false;
}

void SearchDecider::Answer(sdk::Decision& decision) {
  Prepare();
  is_answered_ = true;
  const Verdict inconsistent = engine_->IsInconsistent().verdict;
  if (inconsistent == Verdict::kYes) {
    decision.status = sdk::Status::kInconsistent;
    decision.message = Describe(store_, evaluator_,
                                MinimalCore(store_.theory(), latches_, -1, &evaluator_.spending()));
    return;
  }
  is_unknown_ = inconsistent == Verdict::kUnknown;
  for (std::size_t goal = 0; goal < goals_.size() && !is_unknown_; ++goal) {
    AnswerGoal(goal, decision);
  }
  ListAssumptions(decision);
  if (!is_brave_) ListGrounds(decision);
  ListStates(decision);
  // Without all assumptions, a conclusion would seem to rest on fewer than it does.
  if (!is_unknown_ && !evaluator_.spending().is_spent() && decision.undecided.empty()) {
    decision.status = decision.conclusions.empty() ? sdk::Status::kRefuted : sdk::Status::kProved;
  }
}

SearchDecider::Standing SearchDecider::StandingOf(Literal literal) {
  const Literal contrary = -literal;
  const Verdict holds = is_brave_ ? engine_->HoldsSomewhere({&literal, 1}).verdict
                                  : engine_->EntailsAlways({&literal, 1}).verdict;
  if (holds == Verdict::kYes) return Standing::kConcluded;
  if (holds == Verdict::kUnknown) return Standing::kUnknown;
  if (is_brave_) return Standing::kRefuted;
  const Verdict fails = engine_->EntailsAlways({&contrary, 1}).verdict;
  if (fails == Verdict::kUnknown) return Standing::kUnknown;
  return fails == Verdict::kYes ? Standing::kRefuted : Standing::kUndecided;
}

void SearchDecider::AnswerGoal(std::size_t goal, sdk::Decision& decision) {
  evaluator_.Answer(goals_[goal].rule);
  is_unknown_ = evaluator_.spending().is_spent();
  const FactTable& answers = evaluator_.table(goals_[goal].answers);
  const bool first_only = body_.goals[goal].answers == sdk::Goal::Answers::kFirst;
  bool found = false;
  for (std::uint32_t row = 0; row < answers.size() && !(found && first_only); ++row) {
    const FactRef fact = evaluator_.Premises(answers.info(row)).front();
    const bool by_body = evaluator_.InfoOf(fact).origin == FactInfo::Origin::kBody;
    const Atom atom =
        by_body ? 0 : store_.Find(fact.relation, evaluator_.table(fact.relation).Row(fact.row));
    const Standing standing = atom == 0 ? Standing::kConcluded : StandingOf(atom);
    is_unknown_ = is_unknown_ || standing == Standing::kUnknown;
    if (standing == Standing::kConcluded) {
      decision.conclusions.push_back({goal, evaluator_.FactOf(fact), {}});
      concluded_.push_back(atom);
      found = true;
    } else if (standing == Standing::kUndecided) {
      decision.undecided.push_back({goal, evaluator_.FactOf(fact), {}});
      undecided_.push_back(atom);
    }
  }
}

/// Of the minimized atoms that may hold now: those that hold in no minimal world are assumed false,
/// those that hold in all are retracted.
void SearchDecider::ListAssumptions(sdk::Decision& decision) {
  for (std::size_t relation = 0; relation < program_.relations().size(); ++relation) {
    if (program_.relations()[relation].level == 0) continue;
    const std::uint32_t rows = evaluator_.table(relation).size();
    for (std::uint32_t row = 0; row < rows; ++row) ListAssumption(relation, row, decision);
  }
}

void SearchDecider::ListAssumption(std::size_t relation, std::uint32_t row,
                                   sdk::Decision& decision) {
  if (evaluator_.table(relation).info(row).origin != FactInfo::Origin::kRule) return;
  const Literal atom = store_.Find(relation, evaluator_.table(relation).Row(row));
  const Literal contrary = -atom;
  if (atom == 0) return;
  const bool is_made = engine_->EntailsAlways({&contrary, 1}).verdict == Verdict::kYes;
  if (!is_made && engine_->EntailsAlways({&atom, 1}).verdict != Verdict::kYes) return;
  const FactRef fact{static_cast<std::uint32_t>(relation), row};
  decision.assumptions.push_back(
      {evaluator_.FactOf(fact),
       is_made ? sdk::Assumption::State::kMade : sdk::Assumption::State::kRetracted});
  assumed_.push_back(atom);
  made_.push_back(is_made ? contrary : 0);
}

/// What each conclusion rests on, as few assumptions as will do.
void SearchDecider::ListGrounds(sdk::Decision& decision) {
  for (std::size_t i = 0; i < concluded_.size(); ++i) {
    if (concluded_[i] == 0) continue;
    const auto core = CoreOf(concluded_[i], &evaluator_.spending());
    if (!core) continue;
    for (const Literal literal : core->latches) {
      const auto place = std::find(made_.begin(), made_.end(), literal);
      if (place == made_.end()) continue;
      decision.conclusions[i].assumptions.push_back(
          static_cast<std::size_t>(place - made_.begin()));
    }
    std::sort(decision.conclusions[i].assumptions.begin(),
              decision.conclusions[i].assumptions.end());
  }
}

void SearchDecider::ListStates(sdk::Decision& decision) {
  if (undecided_.size() < 2 || undecided_.size() > kMaxJoint) return;
  for (std::size_t state = 0; state < (std::size_t{1} << undecided_.size()); ++state) {
    std::vector<Literal> literals;
    sdk::GoalState together;
    for (std::size_t i = 0; i < undecided_.size(); ++i) {
      const bool holds = ((state >> i) & 1U) != 0;
      literals.push_back(holds ? undecided_[i] : -undecided_[i]);
      if (holds) together.push_back(i);
    }
    if (engine_->HoldsSomewhere(literals).verdict != Verdict::kNo) {
      decision.states.push_back(std::move(together));
    }
  }
  sdk::Unite(decision.states);
}

/// Latches, assumptions and clauses that make an atom hold; nothing where these do not suffice.
std::optional<Core> SearchDecider::CoreOf(Atom atom, Spending* spending) const {
  std::vector<Literal> made;
  std::copy_if(made_.begin(), made_.end(), std::back_inserter(made),
               [](Literal literal) { return literal != 0; });
  return ReasonsFor(store_.theory(), latches_, made, atom, spending);
}

sdk::Derivation SearchDecider::Explain(const sdk::Decision& decision,
                                       std::size_t conclusion) const {
  if (conclusion >= concluded_.size() || conclusion >= decision.conclusions.size()) return {};
  std::optional<Core> core;
  if (concluded_[conclusion] != 0) core = CoreOf(concluded_[conclusion]);
  return DeriveFromCore(store_, evaluator_, ports_, core, decision.conclusions[conclusion].fact);
}

std::optional<sdk::Explanation> SearchDecider::ExplainAssumption(std::size_t assumption) const {
  if (!is_answered_ || assumption >= assumed_.size()) return std::nullopt;
  const Atom atom = assumed_[assumption];
  const logic::Fact fact = FactOf(store_, evaluator_.bank(), program_.relations(), atom);
  if (made_[assumption] == 0) {
    return sdk::Explanation{
        ToString(fact), true, {}, DeriveFromCore(store_, evaluator_, ports_, CoreOf(atom), fact)};
  }
  auto explanation = SearchReasons(store_, evaluator_, latches_, Limits()).WhyFalse(atom);
  if (explanation) AddMisses(NearMissesOf(fact, evaluator_, symbols_), explanation->misses);
  return explanation;
}

/// The first instance that may hold, an undecided one if there is one; 0: none may.
Atom SearchDecider::FirstOpen(const logic::Atom& pattern) const {
  Atom first = 0;
  for (Atom atom = 1; atom <= static_cast<Atom>(store_.theory().atoms.size()); ++atom) {
    if (store_.place(atom).is_given) continue;
    const logic::Fact fact = FactOf(store_, evaluator_.bank(), program_.relations(), atom);
    if (!Matches(pattern, fact)) continue;
    if (std::find(undecided_.begin(), undecided_.end(), atom) != undecided_.end()) return atom;
    if (first == 0) first = atom;
  }
  return first;
}

std::optional<sdk::Explanation> SearchDecider::WhyNot(const sdk::Decision& decision,
                                                      const logic::Atom& pattern) const {
  if (!is_answered_) return std::nullopt;
  for (std::size_t i = 0; i < decision.conclusions.size(); ++i) {
    const logic::Fact& fact = decision.conclusions[i].fact;
    if (!Matches(pattern, fact)) continue;
    return sdk::Explanation{ToString(pattern), true, {}, Explain(decision, i)};
  }
  std::vector<sdk::NearMiss> misses = NearMissesOf(pattern, evaluator_, symbols_);
  const Atom atom = FirstOpen(pattern);
  if (atom == 0) return sdk::Explanation{ToString(pattern), false, std::move(misses), {}};
  auto explanation = SearchReasons(store_, evaluator_, latches_, Limits()).WhyFalse(atom);
  if (explanation) AddMisses(std::move(misses), explanation->misses);
  return explanation;
}

}  // namespace latchwork::circumscription

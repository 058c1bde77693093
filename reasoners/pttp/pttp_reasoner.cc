// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/pttp_reasoner.h"

#include <fmt/format.h>

#include <algorithm>

#include "reasoners/pttp/options.h"
#include "reasoners/pttp/proofs/derivation.h"
#include "reasoners/pttp/proofs/lacking_premises.h"

namespace latchwork::pttp {

std::span<const sdk::ParameterSpec> PttpReasoner::parameters() const { return LayerOptions(); }

logic::Diagnostics PttpReasoner::Load(const sdk::Body& body, const sdk::Parameters& parameters,
                                      logic::SymbolTable& symbols) {
  body_ = body;
  symbols_ = &symbols;
  theory_ = std::make_unique<Theory>(body_, symbols);
  if (auto diagnostics = theory_->ReadFiles(); !diagnostics.empty()) return diagnostics;
  EngineOptions options;
  options.unique_names = parameters.Boolean("unique_names");
  options.reorder = parameters.Boolean("reorder");
  options.cache_attachments = parameters.Boolean("cache_attachments");
  options.tables = parameters.Boolean("tables");
  options.states = parameters.Boolean("states");
  cache_decisions_ = parameters.Boolean("cache_decisions");
  equality_axioms_ = parameters.Boolean("equality_axioms");
  consistency_inferences_ =
      static_cast<std::uint64_t>(parameters.Integer("consistency_inferences"));
  engine_ = std::make_unique<Engine>(symbols, options);
  for (const auto& input : body_.inputs) engine_->DeclareInput(input);
  for (const auto& minimized : body_.minimized) engine_->DeclareMinimized(minimized);
  for (const auto& attachment : body_.attachments) engine_->DeclareAttachment(attachment, symbols);
  admitted_ = engine_->AddSource("admitted");
  engine_->source(admitted_).is_latch = engine_->source(admitted_).is_scratch = true;
  sources_.clear();
  CompileGoals();
  Recompile();
  return {};
}

void PttpReasoner::CompileGoals() {
  goals_.clear();
  for (const sdk::Goal& goal : body_.goals) {
    const logic::Literal literal{true, goal.pattern};
    Query& query = *goals_.emplace_back(std::make_unique<Query>());
    engine_->CompileQuery({&literal, 1}, goal.variables, query.terms, query.clause);
  }
  memories_.assign(goals_.size(), {});
}

void PttpReasoner::Recompile() {
  engine_->SetTheory(theory_->Clauses(equality_axioms_), body_.facts);
  denials_.clear();
  for (const Contrapositive& start : engine_->program().negatives()) {
    auto denial = std::make_unique<Denial>();
    denial->query.clause = start;
    denial->query.closing = false;
    if (engine_->Prepare(denial->query)) denials_.push_back(std::move(denial));
  }
  VoidMemory();
}

void PttpReasoner::VoidMemory() {
  for (GoalMemory& memory : memories_) memory.validity.Void();
  for (const auto& denial : denials_) denial->unrefuted.Void();
  decided_ = explainable_ = false;
}

logic::Diagnostics PttpReasoner::Tell(std::string_view text) {
  auto diagnostics = theory_->Tell(text);
  if (diagnostics.empty()) Recompile();
  return diagnostics;
}

logic::Diagnostics PttpReasoner::Retract(std::string_view name) {
  auto diagnostics = theory_->Retract(name);
  if (diagnostics.empty()) Recompile();
  return diagnostics;
}

bool PttpReasoner::LoadLatches(std::span<const sdk::Latch> latches) {
  bool changed = latches.size() != sources_.size();
  while (sources_.size() < latches.size()) {
    sources_.push_back(engine_->AddSource(latches[sources_.size()].port));
  }
  for (std::size_t i = 0; i < latches.size(); ++i) {
    FactSource& source = engine_->source(sources_[i]);
    if (source.loaded && source.version == latches[i].version) continue;
    engine_->SetFacts(sources_[i], latches[i].facts);
    source.loaded = source.is_latch = true;
    source.version = latches[i].version;
    changed = true;
  }
  return changed;
}

bool PttpReasoner::MayReuse(const sdk::Budget& budget) const {
  return cache_decisions_ && decided_ && budget.inferences == last_budget_.inferences &&
         budget.depth == last_budget_.depth;
}

sdk::Conclusion& PttpReasoner::AddConclusion(sdk::Decision& decision) {
  if (conclusions_ == decision.conclusions.size()) decision.conclusions.emplace_back();
  return decision.conclusions[conclusions_++];
}

/// Turns proofs of a goal into conclusions, writing over those of the cycle before.
class PttpReasoner::GoalSink final : public ProofSink {
 public:
  GoalSink(PttpReasoner& reasoner, std::size_t goal, sdk::Decision& decision)
      : reasoner_(reasoner), goal_(goal), decision_(decision) {}

  bool Accept(const Proof& proof) override {
    const Contrapositive& start = reasoner_.goals_[goal_]->clause;
    if (!reasoner_.answers_.Enter(goal_, {proof.slots, start.slots}).added) return false;
    logic::Fact fact = reasoner_.engine_->Instance(start.body.front(), proof.slots);
    if (!fact.is_ground()) {
      decision_.message =
          fmt::format("{} was proved for every value, which is no fact", ToString(fact));
      return false;
    }
    sdk::Conclusion& conclusion = reasoner_.AddConclusion(decision_);
    conclusion.goal = goal_;
    conclusion.fact = std::move(fact);
    conclusion.assumptions.clear();
    for (const Resting* resting = proof.resting; resting != nullptr; resting = resting->previous) {
      conclusion.assumptions.push_back(resting->assumption);
    }
    std::sort(conclusion.assumptions.begin(), conclusion.assumptions.end());
    const auto last = std::unique(conclusion.assumptions.begin(), conclusion.assumptions.end());
    conclusion.assumptions.erase(last, conclusion.assumptions.end());
    decision_.statistics.depth = std::max(decision_.statistics.depth, proof.depth);
    return reasoner_.body_.goals[goal_].answers == sdk::Goal::Answers::kFirst;
  }

 private:
  PttpReasoner& reasoner_;
  std::size_t goal_;
  sdk::Decision& decision_;
};

void PttpReasoner::SolveGoal(std::size_t goal, sdk::Decision& decision) {
  if (cache_decisions_ && memories_[goal].validity.Holds(*engine_)) return Recall(goal, decision);
  memories_[goal].validity.Void();
  const std::size_t first = conclusions_;
  const auto wanted =
      body_.goals[goal].answers == sdk::Goal::Answers::kFirst ? Wanted::kFirst : Wanted::kAll;
  engine_->Watch();
  GoalSink sink(*this, goal, decision);
  const SearchEnd end = engine_->Solve(*goals_[goal], wanted, last_budget_.depth, sink);
  const bool decided = end == SearchEnd::kAccepted || end == SearchEnd::kExhausted;
  undecided_ = undecided_ || !decided;
  if (end == SearchEnd::kDepth && decision.limit == sdk::Limit::kNone) {
    decision.limit = sdk::Limit::kDepth;
  }
  const bool certain = decided && !engine_->bound_hit() && engine_->obstacle().empty() &&
                       !engine_->meter().stopped() && decision.message.empty();
  if (cache_decisions_ && certain) Remember(goal, first, decision);
}

namespace {

/// The next place of a list that only grows, so that its elements' memory is reused.
template <typename Element>
Element& Next(std::vector<Element>& elements, std::size_t& count) {
  if (count == elements.size()) elements.emplace_back();
  return elements[count++];
}

}  // namespace

void PttpReasoner::Remember(std::size_t goal, std::size_t first, const sdk::Decision& decision) {
  GoalMemory& memory = memories_[goal];
  memory.validity.Set(*engine_);
  memory.conclusion_count = memory.assumption_count = 0;
  memory.depth = decision.statistics.depth;
  const auto& assumptions = engine_->assumptions();
  place_.assign(assumptions.size(), assumptions.size());
  const auto keep = [&](std::size_t assumption) {
    if (place_[assumption] == assumptions.size()) {
      place_[assumption] = memory.assumption_count;
      Next(memory.assumptions, memory.assumption_count) = assumptions[assumption];
    }
    return place_[assumption];
  };
  for (const std::size_t asked : engine_->asked_assumptions()) keep(asked);
  for (std::size_t i = first; i < conclusions_; ++i) {
    sdk::Conclusion& kept = Next(memory.conclusions, memory.conclusion_count);
    kept = decision.conclusions[i];
    for (std::size_t& assumption : kept.assumptions) assumption = keep(assumption);
  }
}

void PttpReasoner::Recall(std::size_t goal, sdk::Decision& decision) {
  const GoalMemory& memory = memories_[goal];
  place_.clear();
  for (std::size_t i = 0; i < memory.assumption_count; ++i) {
    place_.push_back(engine_->Adopt(memory.assumptions[i]));
  }
  for (std::size_t i = 0; i < memory.conclusion_count; ++i) {
    sdk::Conclusion& conclusion = AddConclusion(decision);
    conclusion = memory.conclusions[i];
    for (std::size_t& assumption : conclusion.assumptions) assumption = place_[assumption];
    std::sort(conclusion.assumptions.begin(), conclusion.assumptions.end());
  }
  decision.statistics.depth = std::max(decision.statistics.depth, memory.depth);
}

/// Learns what a contradiction rests on.
class PttpReasoner::ConflictSink final : public ProofSink {
 public:
  explicit ConflictSink(const Engine& engine) : engine_(engine) {}

  bool Accept(const Proof& proof) override {
    derivation = MakeDerivation(proof, engine_);
    return true;
  }
  /// "clause 'x' with p(a), q(b)", from the facts of latches in the proof.
  std::string Describe(std::string_view clause) const {
    std::string facts;
    for (const auto& step : derivation.steps) {
      if (step.kind != sdk::DerivationStep::Kind::kLatch) continue;
      facts += facts.empty() ? " with " : ", ";
      facts += step.conclusion;
    }
    return fmt::format("clause '{}'{}", clause, facts);
  }
  sdk::Derivation derivation;

 private:
  const Engine& engine_;
};

namespace {

class AnyProof final : public ProofSink {
 public:
  bool Accept(const Proof& /*proof*/) override { return true; }
};

}  // namespace

bool PttpReasoner::Refutes(Denial& denial) {
  if (denial.unrefuted.Holds(*engine_)) return false;
  denial.unrefuted.Void();
  engine_->Watch();
  engine_->meter().LowerCeiling(consistency_inferences_);
  AnyProof sink;
  const SearchEnd end = engine_->Solve(denial.query, Wanted::kAll, last_budget_.depth, sink);
  engine_->meter().RestoreCeiling();
  if (end == SearchEnd::kAccepted) return true;
  if (!engine_->meter().stopped()) denial.unrefuted.Set(*engine_);
  return false;
}

bool PttpReasoner::IsConsistent(sdk::Decision& decision) {
  if (consistency_inferences_ == 0) return true;
  for (const auto& denial : denials_) {
    if (!Refutes(*denial)) continue;
    ConflictSink sink(*engine_);
    engine_->SolveWithSteps(denial->query, last_budget_.depth, sink);
    const std::uint32_t clause = denial->query.clause.clause;
    decision.status = sdk::Status::kInconsistent;
    decision.message = "body and latches contradict each other: " +
                       sink.Describe(engine_->program().clauses()[clause].name);
    return false;
  }
  return true;
}

void PttpReasoner::Finish(sdk::Decision& decision) {
  decision.conclusions.resize(conclusions_);
  decision.assumptions = engine_->assumptions();
  const Meter& meter = engine_->meter();
  decision.statistics.inferences = meter.inferences();
  decision.statistics.attachment_calls = engine_->attachment_calls();
  if (meter.stopped()) decision.limit = meter.limit();
  if (decision.limit == sdk::Limit::kNone && engine_->bound_hit()) {
    decision.limit = sdk::Limit::kDepth;
  }
  if (decision.status == sdk::Status::kInconsistent) return;
  if (undecided_ || meter.stopped()) {
    decision.status = sdk::Status::kUnknown;
    if (!engine_->obstacle().empty()) decision.message = engine_->obstacle();
  } else {
    decision.status = conclusions_ > 0 ? sdk::Status::kProved : sdk::Status::kRefuted;
  }
}

void PttpReasoner::Begin(const sdk::Budget& budget) {
  // What was found within one bound need not hold within another.
  if (budget.depth != last_budget_.depth || budget.inferences != last_budget_.inferences) {
    VoidMemory();
  }
  last_budget_ = budget;
  engine_->Begin(budget);
}

void PttpReasoner::Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                          sdk::Decision& decision) {
  if (!LoadLatches(latches) && MayReuse(budget)) {
    decision = last_;
    return;
  }
  decided_ = false;
  Begin(budget);
  conclusions_ = 0;
  undecided_ = false;
  answers_.Clear();
  decision.limit = sdk::Limit::kNone;
  decision.statistics = {};
  decision.message.clear();
  decision.status = sdk::Status::kUnknown;
  if (IsConsistent(decision)) {
    for (std::size_t i = 0; i < goals_.size() && !engine_->meter().stopped(); ++i) {
      SolveGoal(i, decision);
    }
  }
  Finish(decision);
  explainable_ = true;
  last_ = decision;
  last_.statistics = {};
  decided_ = decision.limit != sdk::Limit::kTime && decision.limit != sdk::Limit::kCancelled;
}

/// Writes down the first proof.
class PttpReasoner::ExplainSink final : public ProofSink {
 public:
  explicit ExplainSink(const Engine& engine) : engine_(engine) {}

  bool Accept(const Proof& proof) override {
    derivation = MakeDerivation(proof, engine_);
    return true;
  }
  sdk::Derivation derivation;

 private:
  const Engine& engine_;
};

sdk::Budget PttpReasoner::BudgetToExplain() const {
  sdk::Budget budget = last_budget_;
  budget.deadline.reset();
  budget.cancelled = nullptr;
  return budget;
}

sdk::Derivation PttpReasoner::DerivationOf(const logic::Atom& atom, const sdk::Budget& budget) {
  engine_->Begin(budget);
  const logic::Literal literal{true, atom};
  Query query;
  engine_->CompileQuery({&literal, 1}, VariablesOf(atom), query.terms, query.clause);
  ExplainSink sink(*engine_);
  engine_->SolveWithSteps(query, budget.depth, sink);
  return std::move(sink.derivation);
}

sdk::Derivation PttpReasoner::Explain(std::size_t conclusion) {
  if (!explainable_ || conclusion >= last_.conclusions.size()) return {};
  return DerivationOf(last_.conclusions[conclusion].fact, BudgetToExplain());
}

std::optional<sdk::Explanation> PttpReasoner::ExplainAssumption(std::size_t assumption) {
  if (!explainable_ || assumption >= last_.assumptions.size()) return std::nullopt;
  const sdk::Assumption& made = last_.assumptions[assumption];
  sdk::Budget budget = BudgetToExplain();
  for (const sdk::Minimized& minimized : body_.minimized) {
    const bool is_bound = minimized.predicate == NameOf(made.atom) && minimized.depth > 0;
    if (is_bound) budget.depth = minimized.depth;
  }
  const bool holds = made.state == sdk::Assumption::State::kRetracted;
  sdk::Explanation explanation{ToString(made.atom), holds, {}, {}};
  if (holds) {
    explanation.derivation = DerivationOf(made.atom, budget);
  } else {
    explanation.misses = LackingPremises(made.atom, budget, *engine_, *symbols_);
  }
  return explanation;
}

std::optional<sdk::Explanation> PttpReasoner::WhyNot(const logic::Atom& pattern) {
  if (!explainable_ || last_.status == sdk::Status::kInconsistent) return std::nullopt;
  const sdk::Budget budget = BudgetToExplain();
  sdk::Explanation explanation{ToString(pattern), false, {}, DerivationOf(pattern, budget)};
  explanation.holds = !explanation.derivation.steps.empty();
  if (!explanation.holds) {
    explanation.misses = LackingPremises(pattern, budget, *engine_, *symbols_);
  }
  return explanation;
}

namespace {

/// While it lives, one source is out of use and another one empty.
class SourceSwap {
 public:
  SourceSwap(Engine& engine, std::size_t hidden, std::size_t shown)
      : engine_(engine), hidden_(hidden), shown_(shown) {
    engine_.source(hidden_).enabled = false;
    engine_.SetFacts(shown_, {});
  }
  SourceSwap(const SourceSwap&) = delete;
  SourceSwap& operator=(const SourceSwap&) = delete;
  ~SourceSwap() {
    engine_.source(hidden_).enabled = true;
    engine_.SetFacts(shown_, {});
  }

 private:
  Engine& engine_;
  std::size_t hidden_;
  std::size_t shown_;
};

}  // namespace

std::string PttpReasoner::Conflict(const logic::Fact& fact, std::uint32_t depth) {
  const logic::Literal denial{false, fact};
  denied_.terms.Clear();
  denied_.closing = false;
  denied_.reach_version = 0;
  engine_->CompileQuery({&denial, 1}, 0, denied_.terms, denied_.clause);
  ConflictSink sink(*engine_);
  if (engine_->SolveWithSteps(denied_, depth, sink) != SearchEnd::kAccepted) return {};
  return "contradicts " + sink.Describe(sink.derivation.steps.back().source);
}

void PttpReasoner::Admit(std::span<const sdk::Latch> latches, std::size_t port,
                         std::span<const logic::Fact> batch, const sdk::Budget& budget,
                         std::vector<sdk::Refusal>& refused) {
  if (!engine_->program().HasNegativeHeads()) return;
  if (LoadLatches(latches)) decided_ = explainable_ = false;
  const SourceSwap swap(*engine_, sources_.at(port), admitted_);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    engine_->Begin(budget);
    if (std::string reason = Conflict(batch[i], budget.depth); !reason.empty()) {
      refused.push_back({i, std::move(reason)});
    } else {
      engine_->AddFact(admitted_, batch[i]);
    }
  }
}

}  // namespace latchwork::pttp

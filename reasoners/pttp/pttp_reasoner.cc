// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/pttp_reasoner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "reasoners/pttp/derivation.h"

namespace latchwork::pttp {

std::span<const sdk::ParameterSpec> PttpReasoner::parameters() const {
  using Type = sdk::ParameterType;
  static const std::array<sdk::ParameterSpec, 6> table{{
      {.name = "unique_names",
       .type = Type::kBoolean,
       .default_value = "false",
       .unit = "",
       .help = "distinct constants, and compound terms of distinct functions, are unequal",
       .choices = {}},
      {.name = "equality_axioms",
       .type = Type::kBoolean,
       .default_value = "false",
       .unit = "",
       .help = "equations that clauses conclude are used everywhere; else `=` is identity after "
               "arithmetic",
       .choices = {}},
      {.name = "cache_attachments",
       .type = Type::kBoolean,
       .default_value = "true",
       .unit = "",
       .help = "an attachment is called once per cycle for the same inputs",
       .choices = {}},
      {.name = "cache_decisions",
       .type = Type::kBoolean,
       .default_value = "true",
       .unit = "",
       .help = "the last decision stands while no latch changes",
       .choices = {}},
      {.name = "reorder",
       .type = Type::kBoolean,
       .default_value = "true",
       .unit = "",
       .help = "facts with a bound argument are looked up before rules are followed",
       .choices = {}},
      {.name = "consistency_inferences",
       .type = Type::kInteger,
       .default_value = "2000",
       .minimum = 0,
       .maximum = 1e9,
       .unit = "",
       .help =
           "what a cycle spends on finding that body and latches contradict each other; 0: nothing",
       .choices = {}},
  }};
  return table;
}

logic::Diagnostics PttpReasoner::Load(const sdk::Body& body, const sdk::Parameters& parameters,
                                      logic::SymbolTable& symbols) {
  body_ = body;
  theory_ = std::make_unique<Theory>(body_, symbols);
  if (auto diagnostics = theory_->ReadFiles(); !diagnostics.empty()) return diagnostics;
  EngineOptions options;
  options.unique_names = parameters.Boolean("unique_names");
  options.reorder = parameters.Boolean("reorder");
  options.cache_attachments = parameters.Boolean("cache_attachments");
  cache_decisions_ = parameters.Boolean("cache_decisions");
  equality_axioms_ = parameters.Boolean("equality_axioms");
  consistency_inferences_ =
      static_cast<std::uint64_t>(parameters.Integer("consistency_inferences"));
  engine_ = std::make_unique<Engine>(symbols, options);
  for (const auto& input : body_.inputs) engine_->DeclareInput(input);
  for (const auto& minimized : body_.minimized) engine_->DeclareMinimized(minimized);
  for (const auto& attachment : body_.attachments) engine_->DeclareAttachment(attachment, symbols);
  admitted_ = engine_->AddSource("admitted");
  engine_->source(admitted_).is_latch = true;
  sources_.clear();
  Recompile();
  goals_.resize(body_.goals.size());
  for (std::size_t i = 0; i < goals_.size(); ++i) {
    const logic::Literal literal{true, body_.goals[i].pattern};
    engine_->CompileQuery({&literal, 1}, body_.goals[i].variables, goal_terms_, goals_[i]);
  }
  return {};
}

void PttpReasoner::Recompile() {
  engine_->SetTheory(theory_->Clauses(equality_axioms_), body_.facts);
  consistency_request_.starts.clear();
  for (const Contrapositive& start : engine_->program().negatives()) {
    const std::array<const Contrapositive*, 1> starts{&start};
    if (engine_->ReachFor(starts, false).viable) consistency_request_.starts.push_back(&start);
  }
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

SearchRequest PttpReasoner::RequestFor(std::size_t goal) {
  SearchRequest request;
  request.starts.assign(1, &goals_[goal]);
  request.reach = &engine_->ReachFor(request.starts, true);
  request.depth = last_budget_.depth;
  return request;
}

/// Turns proofs of a goal into conclusions, writing over those of the cycle before.
class PttpReasoner::GoalSink final : public ProofSink {
 public:
  GoalSink(PttpReasoner& reasoner, std::size_t goal, sdk::Decision& decision)
      : reasoner_(reasoner), goal_(goal), decision_(decision) {}

  bool Accept(const Proof& proof) override {
    const Contrapositive& start = reasoner_.goals_[goal_];
    if (!reasoner_.answers_.Enter(goal_, {proof.slots, start.slots}).added) return false;
    logic::Fact fact = reasoner_.engine_->Instance(start.body.front(), proof.slots);
    if (!fact.is_ground()) {
      decision_.message =
          fmt::format("{} was proved for every value, which is no fact", ToString(fact));
      return false;
    }
    if (reasoner_.conclusions_ == decision_.conclusions.size()) {
      decision_.conclusions.emplace_back();
    }
    sdk::Conclusion& conclusion = decision_.conclusions[reasoner_.conclusions_++];
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
  request_.starts.assign(1, &goals_[goal]);
  request_.reach = &engine_->ReachFor(request_.starts, true);
  request_.depth = last_budget_.depth;
  if (!request_.reach->viable) return;
  GoalSink sink(*this, goal, decision);
  const SearchEnd end = engine_->Search(request_, sink);
  undecided_ = undecided_ || (end != SearchEnd::kAccepted && end != SearchEnd::kExhausted);
  if (end == SearchEnd::kDepth && decision.limit == sdk::Limit::kNone) {
    decision.limit = sdk::Limit::kDepth;
  }
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

bool PttpReasoner::IsConsistent(sdk::Decision& decision) {
  if (consistency_inferences_ == 0 || consistency_request_.starts.empty()) return true;
  for (const Contrapositive* start : consistency_request_.starts) {
    request_.starts.assign(1, start);
    request_.reach = &engine_->ReachFor(request_.starts, false);
    request_.depth = last_budget_.depth;
    request_.record = true;
    engine_->meter().LowerCeiling(consistency_inferences_);
    ConflictSink sink(*engine_);
    const SearchEnd end = engine_->Search(request_, sink);
    engine_->meter().RestoreCeiling();
    request_.record = false;
    if (end != SearchEnd::kAccepted) continue;
    decision.status = sdk::Status::kInconsistent;
    decision.message = "body and latches contradict each other: " +
                       sink.Describe(engine_->program().clauses()[start->clause].name);
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

void PttpReasoner::Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                          sdk::Decision& decision) {
  if (!LoadLatches(latches) && MayReuse(budget)) {
    decision = last_;
    return;
  }
  decided_ = false;
  last_budget_ = budget;
  engine_->Begin(budget);
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

/// Finds the proof of one conclusion again, this time with its steps.
class PttpReasoner::ExplainSink final : public ProofSink {
 public:
  ExplainSink(Engine& engine, const CompiledLiteral& goal, const logic::Fact& fact)
      : engine_(engine), goal_(goal), fact_(fact) {}

  bool Accept(const Proof& proof) override {
    if (engine_.Instance(goal_, proof.slots) != fact_) return false;
    derivation = MakeDerivation(proof, engine_);
    return true;
  }
  sdk::Derivation derivation;

 private:
  Engine& engine_;
  const CompiledLiteral& goal_;
  const logic::Fact& fact_;
};

sdk::Derivation PttpReasoner::Explain(std::size_t conclusion) {
  if (!explainable_ || conclusion >= last_.conclusions.size()) return {};
  sdk::Budget budget = last_budget_;
  budget.deadline.reset();
  budget.cancelled = nullptr;
  engine_->Begin(budget);
  const sdk::Conclusion& wanted = last_.conclusions[conclusion];
  SearchRequest request = RequestFor(wanted.goal);
  request.record = true;
  ExplainSink sink(*engine_, goals_[wanted.goal].body.front(), wanted.fact);
  engine_->Search(request, sink);
  return std::move(sink.derivation);
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

std::string PttpReasoner::Conflict(const logic::Fact& fact, SearchRequest& request) {
  const logic::Literal denial{false, fact};
  Contrapositive query;
  Arena terms;
  engine_->CompileQuery({&denial, 1}, 0, terms, query);
  request.starts.assign(1, &query);
  request.reach = &engine_->ReachFor(request.starts, false);
  if (!request.reach->viable) return {};
  ConflictSink sink(*engine_);
  if (engine_->Search(request, sink) != SearchEnd::kAccepted) return {};
  return "contradicts " + sink.Describe(sink.derivation.steps.back().source);
}

void PttpReasoner::Admit(std::span<const sdk::Latch> latches, std::size_t port,
                         std::span<const logic::Fact> batch, const sdk::Budget& budget,
                         std::vector<sdk::Refusal>& refused) {
  if (!engine_->program().HasNegativeHeads()) return;
  if (LoadLatches(latches)) decided_ = explainable_ = false;
  const SourceSwap swap(*engine_, sources_.at(port), admitted_);
  SearchRequest request;
  request.depth = budget.depth;
  request.record = true;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    engine_->Begin(budget);
    if (std::string reason = Conflict(batch[i], request); !reason.empty()) {
      refused.push_back({i, std::move(reason)});
    } else {
      engine_->AddFact(admitted_, batch[i]);
    }
  }
}

}  // namespace latchwork::pttp

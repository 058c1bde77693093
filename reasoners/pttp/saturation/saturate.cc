// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/saturate.h"

#include <algorithm>

#include "reasoners/pttp/saturation/active_set.h"
#include "reasoners/pttp/saturation/clauses.h"
#include "reasoners/pttp/saturation/inferences.h"
#include "reasoners/pttp/saturation/literal_selection.h"
#include "reasoners/pttp/saturation/ordering.h"
#include "reasoners/pttp/saturation/passive_queue.h"
#include "reasoners/pttp/saturation/relevance.h"
#include "reasoners/pttp/saturation/simplifier.h"
#include "reasoners/pttp/saturation/terms.h"
#include "reasoners/pttp/saturation/translation.h"

namespace latchwork::pttp::saturation {
namespace {

class Loop final : public ConclusionSink {
 public:
  Loop(const Problem& problem, const Options& options, const Limits& limits)
      : problem_(problem),
        options_(options),
        limits_(limits),
        ordering_(terms_),
        clauses_(terms_),
        active_(terms_, clauses_),
        simplifier_(terms_, ordering_, clauses_, active_),
        inferences_(terms_, ordering_, clauses_, active_),
        passive_(clauses_, options),
        translation_(terms_, problem.symbols) {}

  Outcome Run();
  bool Accept(Draft& draft) override;
  bool Stopped() const override { return ended_.has_value(); }

 private:
  void ReadInput();
  void AddInput(std::size_t index);
  void Step(ClauseId passive);
  /// The clause as its active parents leave it; kNoClause when nothing of it is new.
  ClauseId Simplify(ClauseId id, Effort effort);
  ClauseId Keep(Draft& draft);
  void Activate(ClauseId id);
  void Reconsider(ClauseId id);
  void CheckLimits();
  void CheckClock();
  std::vector<pttp::saturation::Step> Proof() const;

  const Problem& problem_;
  const Options& options_;
  const Limits& limits_;
  Terms terms_;
  Ordering ordering_;
  Clauses clauses_;
  ActiveSet active_;
  Simplifier simplifier_;
  Inferences inferences_;
  PassiveQueue passive_;
  Translation translation_;
  Statistics statistics_;
  std::optional<Status> ended_;
  ClauseId empty_ = kNoClause;
  bool complete_ = true;
  std::vector<std::size_t> inputs_;  ///< Of the first clauses: their index in the problem.
};

constexpr std::uint64_t kPollInterval = 16;

void Loop::ReadInput() {
  std::vector<bool> relevant(problem_.clauses.size(), true);
  if (options_.relevance_depth > 0) {
    relevant =
        SelectRelevant(problem_.clauses, options_.relevance_depth, options_.relevance_tolerance);
  }
  for (std::size_t i = 0; i < problem_.clauses.size() && !Stopped(); ++i) {
    if (relevant[i]) {
      AddInput(i);
    } else {
      complete_ = false;
    }
    if (i % kPollInterval == 0) CheckClock();
  }
  translation_.Arrange(options_);
  complete_ = complete_ && !translation_.has_fixed_meaning();
}

void Loop::AddInput(std::size_t index) {
  Draft draft;
  draft.literals = translation_.Read(problem_.clauses[index]);
  const bool goal = problem_.clauses[index].role == logic::Role::kNegatedConjecture;
  clauses_.Add(draft, goal);
  inputs_.push_back(index);
}

void Loop::CheckLimits() {
  if (statistics_.inferences >= options_.max_inferences) ended_ = Status::kInferences;
  if (statistics_.inferences % kPollInterval == 0) CheckClock();
}

void Loop::CheckClock() {
  const std::size_t bytes = terms_.bytes() + clauses_.bytes() + active_.bytes() + passive_.bytes();
  if (bytes > limits_.memory_bytes / 2) ended_ = Status::kMemory;
  if (limits_.stop && limits_.stop()) ended_ = Status::kStopped;
}

ClauseId Loop::Keep(Draft& draft) {
  const ClauseId id = clauses_.Add(draft, false);
  ++statistics_.kept;
  if (draft.literals.empty()) {
    empty_ = id;
    ended_ = Status::kRefuted;
  }
  return id;
}

bool Loop::Accept(Draft& draft) {
  ++statistics_.inferences;
  CheckLimits();
  if (Stopped() || !simplifier_.Forward(draft, Effort::kCheap)) return false;
  const ClauseId id = Keep(draft);
  if (options_.max_size > 0 && clauses_.record(id).size > options_.max_size) {
    clauses_.record(id).state = State::kDead;
    complete_ = false;
    return true;
  }
  passive_.Push(id);
  return true;
}

ClauseId Loop::Simplify(ClauseId id, Effort effort) {
  Draft draft;
  const auto literals = clauses_.literals(id);
  draft.literals.assign(literals.begin(), literals.end());
  draft.rule = Rule::kSimplification;
  draft.parents = {id};
  const bool open = simplifier_.Forward(draft, effort);
  if (!open || draft.changed) clauses_.record(id).state = State::kDead;
  if (!open) return kNoClause;
  if (draft.changed) return Keep(draft);
  std::ranges::copy(draft.literals, clauses_.literals(id).begin());
  return id;
}

void Loop::Reconsider(ClauseId id) {
  active_.Erase(id);
  const ClauseId result = Simplify(id, Effort::kCheap);
  if (result == id) {
    active_.Insert(id);
  } else if (result != kNoClause) {
    passive_.Push(result);
  }
}

void Loop::Activate(ClauseId id) {
  std::vector<ClauseId> subsumed;
  std::vector<ClauseId> touched;
  simplifier_.Backward(id, subsumed, touched);
  for (const ClauseId old : subsumed) {
    active_.Erase(old);
    clauses_.record(old).state = State::kDead;
  }
  MarkEligible(terms_, ordering_, options_.selection, clauses_.literals(id));
  active_.Insert(id);
  clauses_.record(id).state = State::kActive;
  const auto literals = clauses_.literals(id);
  const bool rewrites = literals.size() == 1 && literals[0].positive && literals[0].is_equation();
  if (rewrites) simplifier_.NoteDemodulator();
  for (const ClauseId old : touched) {
    if (!Stopped()) Reconsider(old);
  }
}

void Loop::Step(ClauseId passive) {
  ++statistics_.given;
  if (statistics_.given % kPollInterval == 0) CheckClock();
  const ClauseId given = Simplify(passive, Effort::kFull);
  if (given == kNoClause || Stopped()) return;
  Activate(given);
  const bool silent = options_.set_of_support && !clauses_.record(given).goal;
  if (silent) {
    complete_ = false;
  } else if (!Stopped()) {
    inferences_.Generate(given, *this);
  }
}

std::vector<pttp::saturation::Step> Loop::Proof() const {
  std::vector<std::uint8_t> used(clauses_.size(), 0);
  used[empty_] = 1;
  for (std::size_t id = empty_ + 1; id-- > 0;) {
    if (used[id] == 0) continue;
    for (const ClauseId parent : clauses_.parents(static_cast<ClauseId>(id))) used[parent] = 1;
  }
  std::vector<pttp::saturation::Step> steps;
  std::vector<std::size_t> place(clauses_.size(), 0);
  for (ClauseId id = 0; id <= empty_; ++id) {
    if (used[id] == 0) continue;
    pttp::saturation::Step step;
    step.rule = Name(clauses_.record(id).rule);
    if (id < inputs_.size()) step.input = inputs_[id];
    step.clause =
        step.input ? problem_.clauses[*step.input] : translation_.Write(clauses_.literals(id));
    for (const ClauseId parent : clauses_.parents(id)) step.parents.push_back(place[parent]);
    place[id] = steps.size();
    steps.push_back(std::move(step));
  }
  return steps;
}

Outcome Loop::Run() {
  ReadInput();
  for (ClauseId id = 0; id < inputs_.size() && !Stopped(); ++id) {
    if (clauses_.record(id).literal_count == 0) {
      empty_ = id;
      ended_ = Status::kRefuted;
    }
    passive_.Push(id);
  }
  while (!Stopped()) {
    const ClauseId next = passive_.Pop();
    if (next == kNoClause) {
      complete_ = complete_ && !inferences_.overflowed();
      ended_ = complete_ ? Status::kSaturated : Status::kGaveUp;
    } else {
      Step(next);
    }
  }
  Outcome outcome;
  outcome.status = *ended_;
  outcome.statistics = statistics_;
  if (empty_ != kNoClause) outcome.proof = Proof();
  return outcome;
}

}  // namespace

Outcome Saturate(const Problem& problem, const Options& options, const Limits& limits) {
  return Loop(problem, options, limits).Run();
}

}  // namespace latchwork::pttp::saturation

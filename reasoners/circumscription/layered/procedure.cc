// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/layered/procedure.h"

#include <algorithm>
#include <utility>

namespace latchwork::circumscription {
namespace {

GoalStatus Both(GoalStatus a, GoalStatus b) {
  if (a == b) return a;
  const bool unknown = a == GoalStatus::kUnknown || b == GoalStatus::kUnknown;
  const bool open = a == GoalStatus::kOpen || b == GoalStatus::kOpen;
  return unknown && !open ? GoalStatus::kUnknown : GoalStatus::kOpen;
}

}  // namespace

std::string_view Name(Transfer transfer) {
  if (transfer == Transfer::kSingle) return "single";
  return transfer == Transfer::kOpen ? "open" : "refined";
}

std::optional<Transfer> FindTransfer(std::string_view name) {
  for (const Transfer transfer : kTransfers) {
    if (Name(transfer) == name) return transfer;
  }
  return std::nullopt;
}

std::string_view Name(GoalStatus status) {
  switch (status) {
    case GoalStatus::kProved:
      return "proved";
    case GoalStatus::kRefuted:
      return "refuted";
    case GoalStatus::kOpen:
      return "open";
    case GoalStatus::kUnknown:
      break;
  }
  return "unknown";
}

Procedure::Procedure(const LayeredTheory& theory, Transfer transfer,
                     const ProcedureOptions& options)
    : transfer_(transfer), options_(options) {
  for (std::size_t i = 0; i < theory.layers.size(); ++i) {
    theories_.push_back(WithBridges(theory, i));
    engines_.push_back(std::make_unique<Engine>(theories_.back().theory, options.engine));
  }
  outcomes_.resize(theories_.size());
  states_ = {State()};
  for (std::size_t layer = theories_.size(); layer-- > 0;) RunLayer(layer);
}

void Procedure::SetState(std::size_t layer, const State& state) {
  std::vector<Literal> latches = theories_[layer].latches;
  latches.insert(latches.end(), state.begin(), state.end());
  engines_[layer]->SetLatches(latches);
}

void Procedure::RunLayer(std::size_t layer) {
  LayerOutcome& outcome = outcomes_[layer];
  SetState(layer, states_.front());
  const Verdict inconsistent = engines_[layer]->IsInconsistent().verdict;
  outcome.has_model = inconsistent == Verdict::kUnknown ? Verdict::kUnknown
                      : inconsistent == Verdict::kYes   ? Verdict::kNo
                                                        : Verdict::kYes;
  if (layer == 0) return;
  outcome.goals = theories_[layer - 1].goals;
  std::vector<State> handed;
  for (const State& state : states_) {
    SetState(layer, state);
    const std::vector<GoalStatus> statuses = Decide(layer);
    std::vector<GoalStatus>& all = outcome.statuses;
    if (all.empty()) all = statuses;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = Both(all[i], statuses[i]);
    if (transfer_ == Transfer::kRefined && outcome.has_model != Verdict::kNo) {
      std::vector<Literal> goals;
      Enumerate(layer, 0, goals, handed);
    } else {
      handed.push_back(Handed(statuses, theories_[layer - 1].premises));
    }
    Limit(handed);
  }
  outcome.states = handed.size();
  states_ = std::move(handed);
}

std::vector<GoalStatus> Procedure::Decide(std::size_t layer) {
  std::vector<GoalStatus> statuses;
  for (const Atom goal : outcomes_[layer].goals) {
    if (outcomes_[layer].has_model == Verdict::kNo) {
      statuses.push_back(GoalStatus::kRefuted);
      continue;
    }
    const Literal negated = -goal;
    const Verdict proved = engines_[layer]->EntailsAlways({&goal, 1}).verdict;
    const Verdict refuted = engines_[layer]->EntailsAlways({&negated, 1}).verdict;
    if (proved == Verdict::kYes) {
      statuses.push_back(GoalStatus::kProved);
    } else if (refuted == Verdict::kYes) {
      statuses.push_back(GoalStatus::kRefuted);
    } else if (exact_ && proved == Verdict::kNo && refuted == Verdict::kNo) {
      statuses.push_back(GoalStatus::kOpen);
    } else {
      statuses.push_back(GoalStatus::kUnknown);
    }
  }
  // Below, a goal of which nothing is known may hold or not, whatever the transfer.
  if (std::count(statuses.begin(), statuses.end(), GoalStatus::kUnknown) > 0) exact_ = false;
  return statuses;
}

Procedure::State Procedure::Handed(const std::vector<GoalStatus>& statuses,
                                   const std::vector<Atom>& premises) const {
  State state;
  for (std::size_t i = 0; i < statuses.size(); ++i) {
    if (statuses[i] == GoalStatus::kProved) state.push_back(premises[i]);
    const bool dropped = statuses[i] == GoalStatus::kOpen && transfer_ == Transfer::kSingle;
    if (statuses[i] == GoalStatus::kRefuted || dropped) state.push_back(-premises[i]);
  }
  return state;
}

void Procedure::Enumerate(std::size_t layer, std::size_t next, std::vector<Literal>& goals,
                          std::vector<State>& states) {
  const BridgedTheory& below = theories_[layer - 1];
  if (states.size() > options_.max_states) return;
  if (next == below.goals.size()) {
    State state;
    for (std::size_t i = 0; i < goals.size(); ++i) {
      state.push_back(goals[i] > 0 ? below.premises[i] : -below.premises[i]);
    }
    states.push_back(std::move(state));
    return;
  }
  for (const Literal goal : {below.goals[next], -below.goals[next]}) {
    goals.push_back(goal);
    const Verdict possible = engines_[layer]->HoldsSomewhere(goals).verdict;
    if (possible == Verdict::kUnknown) exact_ = false;
    if (possible != Verdict::kNo) Enumerate(layer, next + 1, goals, states);
    goals.pop_back();
  }
}

/// Each state once; where there are too many, one that leaves everything open.
void Procedure::Limit(std::vector<State>& states) {
  std::sort(states.begin(), states.end());
  states.erase(std::unique(states.begin(), states.end()), states.end());
  if (states.size() <= options_.max_states) return;
  states = {State()};
  exact_ = false;
}

Answer Procedure::Entails(std::span<const Literal> clause) {
  Answer all;
  for (const State& state : states_) {
    SetState(0, state);
    const Answer answer = engines_[0]->EntailsAlways(clause);
    if (answer.verdict == Verdict::kNo && !exact_) return {};
    if (answer.verdict != Verdict::kYes) return answer;
    all = answer;
  }
  return all;
}

}  // namespace latchwork::circumscription

// SPDX-License-Identifier: BSD-3-Clause
#include "core/schedule/each_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace latchwork::schedule {
namespace {

/// No latch counts its own versions that far.
constexpr std::uint64_t kShownVersions = std::uint64_t{1} << 63;

/// All subsets of the facts; nothing when they are too many.
std::vector<sdk::GoalState> Subsets(std::size_t facts) {
  std::vector<sdk::GoalState> subsets;
  if (facts >= 63 || (std::size_t{1} << facts) > EachState::kMostStates) return subsets;
  for (std::size_t bits = 0; bits < (std::size_t{1} << facts); ++bits) {
    sdk::GoalState& state = subsets.emplace_back();
    for (std::size_t i = 0; i < facts; ++i) {
      if ((bits >> i & 1) != 0) state.push_back(i);
    }
  }
  return subsets;
}

}  // namespace

void EachState::Decide(sdk::Reasoner& reasoner, std::span<const sdk::Latch> latches,
                       const sdk::Budget& budget, sdk::Decision& decision) {
  decision.Clear();
  drawn_.clear();
  states_known_ = true;
  if (!ListStates(latches)) {
    decision.status = sdk::Status::kUnknown;
    decision.message = fmt::format(
        "the undecided facts of its latches may be in more than {} joint states", kMostStates);
    return;
  }
  shown_.assign(latches.begin(), latches.end());
  decision.status = sdk::Status::kRefuted;
  for (std::size_t state = 0; state < states_; ++state) {
    sdk::Budget left = budget;
    left.inferences -= std::min(left.inferences, decision.statistics.inferences);
    if (left.inferences == 0) {
      decision.status = sdk::Status::kUnknown;
      decision.limit = sdk::Limit::kInferences;
      states_known_ = false;
      break;
    }
    Show(latches, state);
    reasoner.Decide(shown_, left, one_);
    if (!Add(state, decision)) return;
  }
  Finish(decision);
}

bool EachState::ListStates(std::span<const sdk::Latch> latches) {
  choices_.clear();
  states_ = 1;
  for (const sdk::Latch& latch : latches) {
    const sdk::Undecided& undecided = latch.undecided;
    choices_.push_back(undecided.states.empty() ? Subsets(undecided.facts.size())
                                                : undecided.states);
    states_ = std::min(states_ * choices_.back().size(), kMostStates + 1);
  }
  return states_ > 0 && states_ <= kMostStates;
}

/// The number of a joint state is read with one digit for each latch.
void EachState::Show(std::span<const sdk::Latch> latches, std::size_t state) {
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const sdk::GoalState& chosen = choices_[i][state % choices_[i].size()];
    state /= choices_[i].size();
    const sdk::Undecided& undecided = latches[i].undecided;
    if (undecided.facts.empty()) continue;
    sdk::Latch& shown = shown_[i];
    shown.undecided.Clear();
    shown.version = kShownVersions + shows_++;
    shown.facts = latches[i].facts;
    for (const std::size_t index : chosen) shown.facts.push_back(undecided.facts[index]);
  }
}

bool EachState::Add(std::size_t state, sdk::Decision& decision) {
  decision.statistics.inferences += one_.statistics.inferences;
  decision.statistics.attachment_calls += one_.statistics.attachment_calls;
  decision.statistics.depth = std::max(decision.statistics.depth, one_.statistics.depth);
  if (one_.status == sdk::Status::kFailed || one_.status == sdk::Status::kInconsistent) {
    const sdk::Statistics spent = decision.statistics;
    decision.Clear();
    decision.status =
        one_.status == sdk::Status::kFailed ? sdk::Status::kFailed : sdk::Status::kUnknown;
    decision.statistics = spent;
    decision.message =
        fmt::format("in a state that the undecided facts of its latches may be in: {}",
                    one_.message.empty() ? "the body contradicts them" : one_.message);
    return false;
  }
  if (one_.status == sdk::Status::kUnknown) {
    decision.status = sdk::Status::kUnknown;
    if (one_.limit != sdk::Limit::kNone) decision.limit = one_.limit;
    states_known_ = false;
  }
  for (const sdk::Conclusion& each : one_.conclusions) AddConclusion(state, each, decision);
  for (const sdk::Conclusion& each : one_.undecided) Find(each);
  return true;
}

EachState::Drawn& EachState::Find(const sdk::Conclusion& conclusion) {
  const auto known = std::find_if(drawn_.begin(), drawn_.end(), [&](const Drawn& drawn) {
    return drawn.conclusion.goal == conclusion.goal && drawn.conclusion.fact == conclusion.fact;
  });
  if (known != drawn_.end()) return *known;
  return drawn_.emplace_back(Drawn{{conclusion.goal, conclusion.fact, {}}, {}});
}

void EachState::AddConclusion(std::size_t state, const sdk::Conclusion& conclusion,
                              sdk::Decision& decision) {
  Drawn* const known = &Find(conclusion);
  if (known->states.empty() || known->states.back() != state) known->states.push_back(state);
  std::vector<std::size_t>& rests_on = known->conclusion.assumptions;
  for (const std::size_t index : conclusion.assumptions) {
    const std::size_t place = AddAssumption(one_.assumptions[index], decision);
    if (std::find(rests_on.begin(), rests_on.end(), place) == rests_on.end()) {
      rests_on.push_back(place);
    }
  }
}

std::size_t EachState::AddAssumption(const sdk::Assumption& assumption, sdk::Decision& decision) {
  const auto found =
      std::find(decision.assumptions.begin(), decision.assumptions.end(), assumption);
  if (found != decision.assumptions.end()) {
    return static_cast<std::size_t>(found - decision.assumptions.begin());
  }
  decision.assumptions.push_back(assumption);
  return decision.assumptions.size() - 1;
}

void EachState::Finish(sdk::Decision& decision) {
  std::vector<sdk::GoalState> states(states_);
  std::stable_sort(drawn_.begin(), drawn_.end(), [](const Drawn& a, const Drawn& b) {
    return a.conclusion.goal < b.conclusion.goal;
  });
  for (Drawn& each : drawn_) {
    if (each.states.size() == states_) {
      decision.conclusions.push_back(std::move(each.conclusion));
      continue;
    }
    for (const std::size_t state : each.states) states[state].push_back(decision.undecided.size());
    decision.undecided.push_back(std::move(each.conclusion));
  }
  if (!decision.undecided.empty()) {
    sdk::Unite(states);
    if (states_known_) decision.states = std::move(states);
    decision.status = sdk::Status::kUnknown;
  } else if (decision.status == sdk::Status::kRefuted && !decision.conclusions.empty()) {
    decision.status = sdk::Status::kProved;
  }
}

}  // namespace latchwork::schedule

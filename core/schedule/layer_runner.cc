// SPDX-License-Identifier: BSD-3-Clause
#include "core/schedule/layer_runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/schedule/contain.h"

namespace latchwork::schedule {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<LatchSet::Input> Inputs(const Agent& agent, std::size_t index) {
  std::vector<LatchSet::Input> inputs;
  for (const sdk::PortSpec& port : agent.layers[index].layer->contract().inputs) {
    inputs.push_back({port, false, std::nullopt});
  }
  for (const config::Wire& wire : agent.description.wires) {
    if (wire.to.part != index) continue;
    inputs[wire.to.port].from_sensor = wire.from.part == config::PortAddress::kWorld;
    inputs[wire.to.port].stale_after = wire.stale_after;
  }
  return inputs;
}

}  // namespace

LayerRunner::LayerRunner(const Agent& agent, std::size_t index, Watchdog& watchdog)
    : description_(agent.description.layers[index]),
      layer_(agent.layers[index]),
      index_(index),
      watchdog_(watchdog),
      latches_(Inputs(agent, index), *agent.symbols),
      tally_(agent.description.max_ticks / std::max<std::uint64_t>(description_.period, 1) + 1) {
  budget_.inferences = description_.reasoner.inferences;
  budget_.depth = description_.reasoner.depth;
  budget_.cancelled = &watchdog.cancelled(index);
  for (const sdk::PortSpec& port : layer_.layer->contract().outputs) {
    outputs_.emplace_back(port, *agent.symbols);
  }
  said_.resize(outputs_.size());
}

bool LayerRunner::IsDue(std::uint64_t tick) const {
  const std::uint64_t period = std::max<std::uint64_t>(description_.period, 1);
  return tick >= description_.phase && (tick - description_.phase) % period == 0;
}

void LayerRunner::Cycle(std::uint64_t tick) {
  faults_.clear();
  thrown_.reset();
  decision_.Clear();
  wall_ = std::chrono::nanoseconds(0);
  watchdog_.Begin(index_, tick);
  latches_.Settle(tick, *layer_.reasoner, budget_, settlement_);
  const bool decides = settlement_.problems.empty();
  if (decides) Decide();
  const bool cancelled = watchdog_.End(index_);
  for (const std::string& problem : settlement_.problems) {
    AddFault(tick, FaultKind::kAdmission, problem);
  }
  if (decides) tally_.CountDecision(decision_, wall_);
  tally_.CountRefused(settlement_.refused.size());
  if (auto problem = decides ? Judge(cancelled) : std::nullopt) {
    AddFault(tick, problem->kind, std::move(problem->message));
  }
  Say(!faults_.empty());
}

void LayerRunner::Decide() {
  const auto begin = Clock::now();
  sdk::Reasoner& reasoner = *layer_.reasoner;
  const auto latches = latches_.latches();
  const bool is_decided = std::ranges::all_of(
      latches, [](const sdk::Latch& latch) { return latch.undecided.facts.empty(); });
  thrown_ = Contain([&] {
    if (is_decided || reasoner.takes_undecided() || reasoner.keeps_memory()) {
      reasoner.Decide(latches, budget_, decision_);
    } else {
      each_state_.Decide(reasoner, latches, budget_, decision_);
    }
  });
  wall_ = Clock::now() - begin;
  if (!thrown_) return;
  decision_.Clear();
  decision_.message = *thrown_;
}

std::optional<LayerRunner::Problem> LayerRunner::Judge(bool cancelled) const {
  if (thrown_) return Problem{FaultKind::kException, *thrown_};
  if (cancelled) {
    return Problem{FaultKind::kTimeout, "cancelled: it took longer than the wall limit"};
  }
  if (decision_.statistics.inferences > budget_.inferences) {
    return Problem{FaultKind::kOverBudget,
                   fmt::format("{} inferences were spent, {} allowed",
                               decision_.statistics.inferences, budget_.inferences)};
  }
  if (decision_.status == sdk::Status::kInconsistent) {
    return Problem{FaultKind::kInconsistent, decision_.message};
  }
  if (decision_.status == sdk::Status::kFailed) {
    return Problem{FaultKind::kFailed, decision_.message};
  }
  return JudgeConclusions();
}

std::optional<LayerRunner::Problem> LayerRunner::JudgeConclusions() const {
  for (const auto* list : {&decision_.conclusions, &decision_.undecided}) {
    for (const sdk::Conclusion& each : *list) {
      if (auto problem = JudgeConclusion(each)) return problem;
    }
  }
  for (const sdk::GoalState& state : decision_.states) {
    const bool known = std::ranges::all_of(
        state, [&](std::size_t index) { return index < decision_.undecided.size(); });
    if (!known) {
      return Problem{FaultKind::kBadConclusion,
                     "a state holds a goal that is not among the undecided ones"};
    }
  }
  return std::nullopt;
}

std::optional<LayerRunner::Problem> LayerRunner::JudgeConclusion(
    const sdk::Conclusion& each) const {
  if (each.goal >= layer_.body.goals.size()) {
    return Problem{FaultKind::kBadConclusion,
                   fmt::format("{} belongs to goal {}, but there are only {}",
                               logic::ToString(each.fact), each.goal, layer_.body.goals.size())};
  }
  std::string offence = outputs_[layer_.body.goals[each.goal].port].Offence(each.fact);
  if (!offence.empty()) {
    return Problem{FaultKind::kBadConclusion,
                   fmt::format("{}: {}", logic::ToString(each.fact), offence)};
  }
  const bool known = std::all_of(each.assumptions.begin(), each.assumptions.end(),
                                 [&](std::size_t i) { return i < decision_.assumptions.size(); });
  if (known) return std::nullopt;
  return Problem{FaultKind::kBadConclusion,
                 fmt::format("{} rests on an assumption that the decision does not list",
                             logic::ToString(each.fact))};
}

void LayerRunner::Say(bool fallback) {
  for (std::size_t port = 0; port < said_.size(); ++port) {
    said_[port].updated = true;
    said_[port].facts.clear();
    said_[port].undecided.Clear();
    if (fallback) said_[port].facts = layer_.fallback[port];
  }
  if (fallback) return;
  for (const sdk::Conclusion& each : decision_.conclusions) {
    said_[layer_.body.goals[each.goal].port].facts.push_back(each.fact);
  }
  if (!decision_.undecided.empty()) SayUndecided();
}

/// Each port gets its own goals, and its share of every state.
void LayerRunner::SayUndecided() {
  std::vector<std::size_t> places;
  for (const sdk::Conclusion& each : decision_.undecided) {
    std::vector<logic::Fact>& facts = said_[layer_.body.goals[each.goal].port].undecided.facts;
    places.push_back(facts.size());
    facts.push_back(each.fact);
  }
  for (std::size_t port = 0; port < said_.size(); ++port) {
    sdk::Undecided& undecided = said_[port].undecided;
    if (undecided.facts.empty()) continue;
    for (const sdk::GoalState& state : decision_.states) {
      sdk::GoalState& share = undecided.states.emplace_back();
      for (const std::size_t index : state) {
        if (layer_.body.goals[decision_.undecided[index].goal].port == port) {
          share.push_back(places[index]);
        }
      }
    }
    sdk::Unite(undecided.states);
  }
}

void LayerRunner::AddFault(std::uint64_t tick, FaultKind kind, std::string message) {
  faults_.push_back({tick, index_, description_.reasoner.plugin, kind, std::move(message)});
  tally_.CountFault();
}

LayerStatistics LayerRunner::Statistics() const {
  LayerStatistics statistics = tally_.Sum();
  statistics.name = description_.name;
  statistics.plugin = description_.plugin;
  statistics.reasoner = description_.reasoner.plugin;
  return statistics;
}

}  // namespace latchwork::schedule

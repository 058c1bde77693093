// SPDX-License-Identifier: BSD-3-Clause
#include "core/schedule/arbitration.h"

#include <algorithm>
#include <string>
#include <utility>

namespace latchwork::schedule {

using config::PortAddress;

Arbitration::Arbitration(const Agent& agent)
    : layers_(agent.layers.size()), sensors_(agent.world->contract().outputs.size()) {
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    layers_[i].latency = agent.description.layers[i].latency;
    layers_[i].spoken.resize(agent.layers[i].layer->contract().outputs.size());
    layers_[i].inhibited.resize(layers_[i].spoken.size());
  }
  std::copy_if(agent.description.wires.begin(), agent.description.wires.end(),
               std::back_inserter(wires_),
               [](const config::Wire& wire) { return wire.from.part != PortAddress::kWorld; });
  AddEffectors(agent);
  AddInhibitions(agent);
}

void Arbitration::AddEffectors(const Agent& agent) {
  for (const sdk::PortSpec& port : agent.world->contract().inputs) {
    effectors_.push_back({PortContract(port, *agent.symbols), {}, 1, std::nullopt});
  }
  commands_.resize(effectors_.size());
  for (const config::Wire& wire : wires_) {
    if (wire.to.part != PortAddress::kWorld) continue;
    const std::uint64_t period = agent.description.layers[wire.from.part].period;
    effectors_[wire.to.port].source = wire.from;
    effectors_[wire.to.port].hold = std::max<std::uint64_t>(wire.stale_after.value_or(period), 1);
  }
}

void Arbitration::AddInhibitions(const Agent& agent) {
  for (const config::Inhibition& each : agent.description.inhibitions) {
    const sdk::Contract& contract = agent.layers[each.output.part].layer->contract();
    if (!contract.outputs[each.output.port].uninhibitable) inhibitions_.push_back(each);
  }
}

void Arbitration::Accept(std::size_t layer, std::uint64_t tick, std::span<const sdk::Batch> said) {
  LayerState& state = layers_[layer];
  Waiting entry;
  if (!state.spare.empty()) {
    entry = std::move(state.spare.back());
    state.spare.pop_back();
  }
  entry.leave = tick + state.latency;
  entry.said.assign(said.begin(), said.end());
  state.waiting.push_back(std::move(entry));
}

void Arbitration::NoteSensor(std::size_t port, std::uint64_t tick, bool has_facts) {
  sensors_[port] = {tick, has_facts};
}

void Arbitration::Release(std::uint64_t tick, const Deliver& deliver, TickRecord& record) {
  TakeDue(tick);
  Inhibit(tick, record);
  Address(tick, deliver, record);
  Silence(tick);
}

void Arbitration::TakeDue(std::uint64_t tick) {
  for (LayerState& state : layers_) {
    state.leaves = !state.waiting.empty() && state.waiting.front().leave <= tick;
    state.inhibited.assign(state.inhibited.size(), false);
    if (!state.leaves) continue;
    state.spare.push_back(std::move(state.leaving));
    state.leaving = std::move(state.waiting.front());
    state.waiting.pop_front();
    for (std::size_t port = 0; port < state.spoken.size(); ++port) {
      state.spoken[port] = {tick, !state.leaving.said[port].facts.empty()};
    }
  }
}

/// The last batch of the inhibiting port counts whether it left itself or not: with that, the order
/// of the inhibitions does not matter.
void Arbitration::Inhibit(std::uint64_t tick, TickRecord& record) {
  for (const config::Inhibition& each : inhibitions_) {
    const Spoken& by = each.by.part == PortAddress::kWorld
                           ? sensors_[each.by.port]
                           : layers_[each.by.part].spoken[each.by.port];
    if (!by.has_facts || tick - by.tick >= std::max<std::uint64_t>(each.hold, 1)) continue;
    LayerState& state = layers_[each.output.part];
    if (state.leaves && !state.inhibited[each.output.port]) record.inhibited.push_back(each.output);
    state.inhibited[each.output.port] = true;
  }
}

void Arbitration::Address(std::uint64_t tick, const Deliver& deliver, TickRecord& record) {
  for (const config::Wire& wire : wires_) {
    const LayerState& state = layers_[wire.from.part];
    if (!state.leaves || state.inhibited[wire.from.port]) continue;
    const sdk::Batch& batch = state.leaving.said[wire.from.port];
    if (wire.to.part == PortAddress::kWorld) {
      Tell(wire.to, tick, batch.facts, record);
    } else {
      deliver(wire.to, HandDown(batch, wire.transfer), tick + 1);
    }
  }
}

const sdk::Batch& Arbitration::HandDown(const sdk::Batch& batch, config::Transfer transfer) {
  if (batch.undecided.facts.empty() || transfer == config::Transfer::kRefined) return batch;
  handed_ = batch;
  handed_.undecided.states.clear();
  if (transfer == config::Transfer::kSingle) handed_.undecided.facts.clear();
  return handed_;
}

void Arbitration::Tell(const PortAddress& to, std::uint64_t tick,
                       const std::vector<logic::Fact>& batch, TickRecord& record) {
  EffectorState& effector = effectors_[to.port];
  effector.told = tick;
  commands_[to.port].facts.clear();
  for (const logic::Fact& fact : batch) {
    if (!effector.contract.Declares(fact)) continue;
    std::string offence = effector.contract.Offence(fact);
    if (offence.empty()) {
      commands_[to.port].facts.push_back(fact);
    } else {
      record.refused.push_back({to, fact, std::move(offence)});
    }
  }
}

/// An effector is told nothing while its source is inhibited, and once what it was told is too old.
void Arbitration::Silence(std::uint64_t tick) {
  for (std::size_t port = 0; port < effectors_.size(); ++port) {
    const EffectorState& effector = effectors_[port];
    const bool wired = effector.source.part != PortAddress::kWorld;
    const bool inhibited = wired && layers_[effector.source.part].inhibited[effector.source.port];
    commands_[port].updated = wired && effector.told == tick && !inhibited;
    const bool is_old = !effector.told || tick - *effector.told >= effector.hold;
    if (inhibited || is_old) commands_[port].facts.clear();
  }
}

}  // namespace latchwork::schedule

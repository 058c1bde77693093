// SPDX-License-Identifier: BSD-3-Clause
#include "core/record/tick_encoder.h"

#include <algorithm>

#include "latchwork/sdk/contract.h"

namespace latchwork::record {
namespace {

std::vector<std::string> PortNames(const std::vector<sdk::PortSpec>& ports) {
  std::vector<std::string> names;
  names.reserve(ports.size());
  for (const sdk::PortSpec& port : ports) names.push_back(port.name);
  return names;
}

}  // namespace

TickEncoder::TickEncoder(const schedule::Agent& agent)
    : effectors_(PortNames(agent.world->contract().inputs)),
      sensors_(PortNames(agent.world->contract().outputs)),
      commands_(effectors_.size()) {
  for (std::size_t i = 0; i < agent.layers.size(); ++i) {
    const sdk::Contract& contract = agent.layers[i].layer->contract();
    Layer layer{agent.description.layers[i].name,
                PortNames(contract.inputs),
                PortNames(contract.outputs),
                {}};
    for (const sdk::Goal& goal : agent.layers[i].body.goals) layer.goal_ports.push_back(goal.port);
    layers_.push_back(std::move(layer));
  }
}

const std::string& TickEncoder::Encode(const schedule::TickRecord& record) {
  json_.Clear();
  json_.Begin('{');
  NumberMember("tick", record.tick);
  json_.Member("events", '[', ']', [&] { Events(record); });
  json_.Member("sensed", '{', '}', [&] { Sensed(record); });
  json_.Member("latched", '[', ']', [&] { Latched(record); });
  json_.Member("refused", '[', ']', [&] { Refused(record); });
  json_.Member("decisions", '[', ']', [&] {
    for (const schedule::DecisionRecord& each : record.decisions) Decision(each);
  });
  json_.Member("inhibited", '[', ']', [&] { Inhibited(record); });
  json_.Member("commands", '{', '}', [&] { Commands(record); });
  json_.Member("faults", '[', ']', [&] { Faults(record); });
  json_.End('}');
  return json_.text();
}

void TickEncoder::TextMember(std::string_view name, std::string_view text) {
  json_.Key(name);
  json_.Text(text);
}

void TickEncoder::NumberMember(std::string_view name, std::uint64_t number) {
  json_.Key(name);
  json_.Number(number);
}

void TickEncoder::Events(const schedule::TickRecord& record) {
  for (const schedule::EventRecord& event : record.events) {
    json_.Begin('{');
    json_.Key("fact");
    json_.Fact(event.fact);
    if (!event.problem.empty()) TextMember("problem", event.problem);
    json_.End('}');
  }
}

void TickEncoder::Sensed(const schedule::TickRecord& record) {
  for (std::size_t port = 0; port < record.sensors.size(); ++port) {
    if (!record.sensors[port].updated) continue;
    json_.Key(sensors_[port]);
    json_.Facts(record.sensors[port].facts);
  }
}

void TickEncoder::Latched(const schedule::TickRecord& record) {
  for (const schedule::LatchRecord& each : record.latched) {
    const Layer& layer = layers_[each.layer];
    json_.Begin('{');
    TextMember("layer", layer.name);
    TextMember("latch", layer.inputs[each.port]);
    if (each.stale) {
      json_.Key("stale");
      json_.Boolean(true);
    }
    json_.Key("facts");
    json_.Facts(each.facts);
    if (each.undecided != nullptr && !each.undecided->facts.empty()) Undecided(*each.undecided);
    NumberMember("version", each.version);
    json_.End('}');
  }
}

void TickEncoder::Refused(const schedule::TickRecord& record) {
  for (const schedule::RefusalRecord& each : record.refused) {
    json_.Begin('{');
    if (each.to.part == config::PortAddress::kWorld) {
      TextMember("effector", effectors_[each.to.port]);
    } else {
      TextMember("layer", layers_[each.to.part].name);
      TextMember("latch", layers_[each.to.part].inputs[each.to.port]);
    }
    json_.Key("fact");
    json_.Fact(each.fact);
    TextMember("reason", each.reason);
    json_.End('}');
  }
}

void TickEncoder::Decision(const schedule::DecisionRecord& record) {
  const Layer& layer = layers_[record.layer];
  const sdk::Decision& decision = *record.decision;
  json_.Begin('{');
  TextMember("layer", layer.name);
  TextMember("status", sdk::Name(decision.status));
  if (decision.limit != sdk::Limit::kNone) TextMember("limit", sdk::Name(decision.limit));
  json_.Member("conclusions", '[', ']', [&] { Conclusions(layer, decision.conclusions); });
  if (!decision.undecided.empty()) {
    json_.Member("undecided", '[', ']', [&] { Conclusions(layer, decision.undecided); });
    if (!decision.states.empty()) States(decision.states);
  }
  json_.Member("assumptions", '[', ']', [&] { Assumptions(decision); });
  NumberMember("inferences", decision.statistics.inferences);
  NumberMember("depth", decision.statistics.depth);
  NumberMember("attachment_calls", decision.statistics.attachment_calls);
  if (!decision.message.empty()) TextMember("message", decision.message);
  if (record.fallback) Said(layer, record);
  json_.End('}');
}

void TickEncoder::Undecided(const sdk::Undecided& undecided) {
  json_.Key("undecided");
  json_.Facts(undecided.facts);
  if (!undecided.states.empty()) States(undecided.states);
}

void TickEncoder::States(const std::vector<sdk::GoalState>& states) {
  json_.Member("states", '[', ']', [&] {
    for (const sdk::GoalState& state : states) {
      json_.Begin('[');
      Indices(state);
      json_.End(']');
    }
  });
}

void TickEncoder::Indices(const std::vector<std::size_t>& indices) {
  for (const std::size_t index : indices) json_.Number(static_cast<std::uint64_t>(index));
}

void TickEncoder::Conclusions(const Layer& layer, const std::vector<sdk::Conclusion>& conclusions) {
  for (const sdk::Conclusion& conclusion : conclusions) {
    json_.Begin('{');
    // What a faulty reasoner names as its goal need not exist.
    if (conclusion.goal < layer.goal_ports.size()) {
      TextMember("port", layer.outputs[layer.goal_ports[conclusion.goal]]);
    }
    json_.Key("fact");
    json_.Fact(conclusion.fact);
    json_.Member("rests_on", '[', ']', [&] { Indices(conclusion.assumptions); });
    json_.End('}');
  }
}

void TickEncoder::Assumptions(const sdk::Decision& decision) {
  for (const sdk::Assumption& each : decision.assumptions) {
    json_.Begin('{');
    json_.Key(sdk::Name(each.state));
    json_.Fact(each.atom);
    json_.End('}');
  }
}

void TickEncoder::Said(const Layer& layer, const schedule::DecisionRecord& record) {
  json_.Key("fallback");
  json_.Begin('{');
  for (std::size_t port = 0; port < record.said.size(); ++port) {
    json_.Key(layer.outputs[port]);
    json_.Facts(record.said[port].facts);
  }
  json_.End('}');
}

void TickEncoder::Inhibited(const schedule::TickRecord& record) {
  for (const config::PortAddress& each : record.inhibited) {
    json_.Begin('{');
    TextMember("layer", layers_[each.part].name);
    TextMember("port", layers_[each.part].outputs[each.port]);
    json_.End('}');
  }
}

void TickEncoder::Commands(const schedule::TickRecord& record) {
  for (std::size_t port = 0; port < record.commands.size(); ++port) {
    const std::vector<logic::Fact>& facts = record.commands[port].facts;
    if (facts == commands_[port]) continue;
    commands_[port] = facts;
    json_.Key(effectors_[port]);
    json_.Facts(facts);
  }
}

void TickEncoder::Faults(const schedule::TickRecord& record) {
  for (const schedule::Fault& each : record.faults) {
    json_.Begin('{');
    if (each.layer != schedule::Fault::kWorld) TextMember("layer", layers_[each.layer].name);
    TextMember("plugin", each.plugin);
    TextMember("kind", schedule::Name(each.kind));
    TextMember("message", each.message);
    json_.End('}');
  }
}

const std::string& TickEncoder::EncodeEnd(const schedule::RunResult& result) {
  json_.Clear();
  json_.Begin('{');
  json_.Key("end");
  json_.Begin('{');
  TextMember("outcome", schedule::Name(result.state));
  TextMember("message", result.message);
  NumberMember("ticks", result.ticks);
  json_.Key("measures");
  json_.Begin('{');
  for (const auto& [name, value] : result.measures) {
    json_.Key(name);
    json_.Number(value);
  }
  for (int open = 0; open < 3; ++open) json_.End('}');
  return json_.text();
}

}  // namespace latchwork::record

// SPDX-License-Identifier: BSD-3-Clause
#include "core/record/tick_encoder.h"

#include <span>
#include <utility>

#include "latchwork/sdk/contract.h"

namespace latchwork::record {
namespace {

std::vector<std::string> PortNames(const std::vector<sdk::PortSpec>& ports) {
  std::vector<std::string> names;
  for (const sdk::PortSpec& port : ports) names.push_back(port.name);
  return names;
}

Json Texts(std::span<const logic::Fact> facts) {
  Json texts = Json::array();
  for (const logic::Fact& fact : facts) texts.push_back(logic::ToString(fact));
  return texts;
}

Json Events(const std::vector<schedule::EventRecord>& events) {
  Json all = Json::array();
  for (const schedule::EventRecord& event : events) {
    Json one = {{"fact", logic::ToString(event.fact)}};
    if (!event.problem.empty()) one["problem"] = event.problem;
    all.push_back(std::move(one));
  }
  return all;
}

Json Conclusions(const sdk::Decision& decision) {
  Json all = Json::array();
  for (const sdk::Conclusion& conclusion : decision.conclusions) {
    all.push_back({{"fact", logic::ToString(conclusion.fact)},
                   {"goal", conclusion.goal},
                   {"assumptions", conclusion.assumptions}});
  }
  return all;
}

/// Pairs, for there are many: [atom, state].
Json Assumptions(const sdk::Decision& decision) {
  Json all = Json::array();
  for (const sdk::Assumption& each : decision.assumptions) {
    all.push_back({logic::ToString(each.atom), sdk::Name(each.state)});
  }
  return all;
}

void AddUnlessEmpty(Json& object, const char* name, Json value) {
  if (!value.empty()) object[name] = std::move(value);
}

}  // namespace

std::string Dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

TickEncoder::TickEncoder(const schedule::Agent& agent)
    : world_{"world", PortNames(agent.world->contract().inputs),
             PortNames(agent.world->contract().outputs)},
      sensed_(world_.outputs.size()) {
  for (std::size_t i = 0; i < agent.layers.size(); ++i) {
    const sdk::Contract& contract = agent.layers[i].layer->contract();
    layers_.push_back({agent.description.layers[i].name, PortNames(contract.inputs),
                       PortNames(contract.outputs)});
  }
}

const TickEncoder::Names& TickEncoder::Of(std::size_t part) const {
  return part == config::PortAddress::kWorld ? world_ : layers_[part];
}

std::string TickEncoder::Encode(const schedule::TickRecord& record) {
  Json tick = {{"tick", record.tick}};
  AddUnlessEmpty(tick, "events", Events(record.events));
  AddUnlessEmpty(tick, "sensed", Sensed(record));
  AddUnlessEmpty(tick, "latched", Latched(record));
  AddUnlessEmpty(tick, "refused", Refused(record));
  AddUnlessEmpty(tick, "decisions", Decisions(record));
  AddUnlessEmpty(tick, "inhibited", Inhibited(record));
  AddUnlessEmpty(tick, "commands", Commands(record));
  AddUnlessEmpty(tick, "faults", Faults(record));
  return Dump(tick);
}

Json TickEncoder::Sensed(const schedule::TickRecord& record) {
  Json all = Json::object();
  for (std::size_t port = 0; port < record.sensors.size(); ++port) {
    const sdk::Batch& batch = record.sensors[port];
    if (!batch.updated || batch.facts == sensed_[port]) continue;
    sensed_[port] = batch.facts;
    all[world_.outputs[port]] = Texts(batch.facts);
  }
  return all;
}

Json TickEncoder::Latched(const schedule::TickRecord& record) const {
  Json all = Json::array();
  for (const schedule::LatchRecord& each : record.latched) {
    Json one = {{"layer", layers_[each.layer].name},
                {"latch", layers_[each.layer].inputs[each.port]},
                {"version", each.version}};
    if (each.stale) one["stale"] = true;
    one["facts"] = Texts(each.facts);
    all.push_back(std::move(one));
  }
  return all;
}

Json TickEncoder::Refused(const schedule::TickRecord& record) const {
  Json all = Json::array();
  for (const schedule::RefusalRecord& each : record.refused) {
    const Names& to = Of(each.to.part);
    all.push_back({{"to", to.name + "." + to.inputs[each.to.port]},
                   {"fact", logic::ToString(each.fact)},
                   {"reason", each.reason}});
  }
  return all;
}

Json TickEncoder::Decisions(const schedule::TickRecord& record) const {
  Json all = Json::array();
  for (const schedule::DecisionRecord& each : record.decisions) {
    const sdk::Decision& decision = *each.decision;
    Json one = {{"layer", layers_[each.layer].name}, {"status", sdk::Name(decision.status)}};
    if (decision.limit != sdk::Limit::kNone) one["limit"] = sdk::Name(decision.limit);
    AddUnlessEmpty(one, "conclusions", Conclusions(decision));
    AddUnlessEmpty(one, "assumptions", Assumptions(decision));
    one["inferences"] = decision.statistics.inferences;
    one["depth"] = decision.statistics.depth;
    one["attachment_calls"] = decision.statistics.attachment_calls;
    if (!decision.message.empty()) one["message"] = decision.message;
    if (each.fallback) one["fallback"] = Said(each);
    all.push_back(std::move(one));
  }
  return all;
}

Json TickEncoder::Said(const schedule::DecisionRecord& record) const {
  Json all = Json::object();
  for (std::size_t port = 0; port < record.said.size(); ++port) {
    all[layers_[record.layer].outputs[port]] = Texts(record.said[port].facts);
  }
  return all;
}

Json TickEncoder::Inhibited(const schedule::TickRecord& record) const {
  Json all = Json::array();
  for (const config::PortAddress& each : record.inhibited) {
    all.push_back(Of(each.part).name + "." + Of(each.part).outputs[each.port]);
  }
  return all;
}

Json TickEncoder::Commands(const schedule::TickRecord& record) const {
  Json all = Json::object();
  for (std::size_t port = 0; port < record.commands.size(); ++port) {
    if (record.commands[port].facts.empty()) continue;
    all[world_.inputs[port]] = Texts(record.commands[port].facts);
  }
  return all;
}

Json TickEncoder::Faults(const schedule::TickRecord& record) const {
  Json all = Json::array();
  for (const schedule::Fault& each : record.faults) {
    all.push_back({{"layer", Of(each.layer).name},
                   {"plugin", each.plugin},
                   {"kind", schedule::Name(each.kind)},
                   {"message", each.message}});
  }
  return all;
}

std::string TickEncoder::EncodeEnd(const schedule::RunResult& result) {
  Json measures = Json::object();
  for (const auto& [name, value] : result.measures) measures[name] = value;
  return Dump({{"end",
                {{"outcome", schedule::Name(result.state)},
                 {"message", result.message},
                 {"ticks", result.ticks},
                 {"measures", std::move(measures)}}}});
}

}  // namespace latchwork::record

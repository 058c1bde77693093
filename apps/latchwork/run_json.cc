// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/run_json.h"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "apps/latchwork/run_table.h"

namespace latchwork::app {
namespace {

using Json = nlohmann::ordered_json;

Json LayerJson(const schedule::LayerStatistics& layer) {
  const schedule::Spread& time = layer.time_us;
  return {{"name", layer.name},
          {"plugin", layer.plugin},
          {"reasoner", layer.reasoner},
          {"decisions", layer.decisions},
          {"time_us",
           {{"mean", time.mean},
            {"sd", time.sd},
            {"p50", time.p50},
            {"p99", time.p99},
            {"max", time.max}}},
          {"inferences", {{"mean", layer.inferences.mean}, {"sd", layer.inferences.sd}}},
          {"budget_hits", layer.budget_hits},
          {"assumed_by_bound", layer.assumed_by_bound},
          {"retracted", layer.retracted},
          {"refused", layer.refused},
          {"faults", layer.faults}};
}

Json FaultJson(const schedule::Fault& fault, const FinishedRun& run) {
  const bool of_world = fault.layer == schedule::Fault::kWorld;
  return {{"tick", fault.tick},
          {"layer", of_world ? Json() : Json(run.layer_names[fault.layer])},
          {"plugin", fault.plugin},
          {"kind", schedule::Name(fault.kind)},
          {"message", fault.message}};
}

Json EventsJson(const std::vector<EventNote>& events) {
  Json list = Json::array();
  for (const EventNote& event : events) {
    list.push_back({{"tick", event.tick}, {"fact", event.fact}, {"problem", event.problem}});
  }
  return list;
}

Json MeasuresJson(const schedule::RunResult& result) {
  Json measures = Json::object();
  for (const auto& [name, value] : result.measures) measures[name] = value;
  return measures;
}

Json RunJson(const FinishedRun& run) {
  const schedule::RunResult& result = run.result;
  Json layers = Json::array();
  for (const schedule::LayerStatistics& layer : result.layers) layers.push_back(LayerJson(layer));
  Json faults = Json::array();
  for (const schedule::Fault& fault : run.faults) faults.push_back(FaultJson(fault, run));
  return {{"outcome", run.began ? Json(schedule::Name(result.state)) : Json("did not begin")},
          {"message", result.message},
          {"collisions", static_cast<std::uint64_t>(Measure(result, "collisions"))},
          {"ticks", result.ticks},
          {"seed", run.request.seed},
          {"agent", run.agent_name},
          {"agent_file", run.request.agent_file.string()},
          {"command", CommandOf(run.request)},
          {"tick_s", run.tick_s},
          {"duration_s", run.duration_s},
          {"measures", MeasuresJson(result)},
          {"layers", std::move(layers)},
          {"events", EventsJson(run.events)},
          {"faults", std::move(faults)},
          {"trajectory", run.trajectory},
          {"errors", run.errors}};
}

}  // namespace

std::string ToJson(const std::vector<FinishedRun>& runs) {
  Json all = Json::array();
  for (const FinishedRun& run : runs) all.push_back(RunJson(run));
  const Json& json = runs.size() == 1 ? all.front() : all;
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace latchwork::app

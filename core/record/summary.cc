// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/record/summary.h"

#include "core/record/tick_encoder.h"

namespace latchwork::record {
namespace {

Json LayerJson(const schedule::LayerStatistics& layer) {
  return {{"name", layer.name},
          {"plugin", layer.plugin},
          {"reasoner", layer.reasoner},
          {"decisions", layer.decisions},
          {"time_us",
           {{"mean", layer.time_us.mean},
            {"sd", layer.time_us.sd},
            {"p50", layer.time_us.p50},
            {"p99", layer.time_us.p99},
            {"max", layer.time_us.max}}},
          {"inferences", {{"mean", layer.inferences.mean}, {"sd", layer.inferences.sd}}},
          {"budget_hits", layer.budget_hits},
          {"retracted", layer.retracted},
          {"assumed_by_bound", layer.assumed_by_bound},
          {"faults", layer.faults},
          {"refused", layer.refused}};
}

}  // namespace

std::string SummaryJson(const schedule::RunResult& result) {
  double collisions = 0;
  Json measures = Json::object();
  for (const auto& [name, value] : result.measures) {
    measures[name] = value;
    if (name == "collisions") collisions = value;
  }
  Json layers = Json::array();
  for (const schedule::LayerStatistics& layer : result.layers) layers.push_back(LayerJson(layer));
  return Dump({{"outcome", schedule::Name(result.state)},
               {"message", result.message},
               {"collisions", static_cast<std::uint64_t>(collisions)},
               {"ticks", result.ticks},
               {"seed", result.seed},
               {"wall_seconds", result.wall_seconds},
               {"layers", std::move(layers)},
               {"measures", std::move(measures)}});
}

}  // namespace latchwork::record

// SPDX-License-Identifier: BSD-3-Clause
//
// The paper's ablations (LSA, IJCAI-99, section 5): no caching, layers 2 and 3 as one theory, and
// all four layers as one. Each decides over the sensor latches of recorded cycles of scenario 3.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/cpu_clock.h"
#include "tests/bench/recording.h"

namespace latchwork {
namespace {

struct Ablation {
  std::string_view name;
  std::vector<std::size_t> layers;  ///< Lowest first; its goals are asked.
  bool cache;
};

const std::array<Ablation, 9> kAblations{{
    {"layer_0", {0}, true},
    {"layer_0_cache_off", {0}, false},
    {"layer_2", {2}, true},
    {"layer_2_cache_off", {2}, false},
    {"layer_3", {3}, true},
    {"layer_3_cache_off", {3}, false},
    {"layers_2_and_3_merged", {2, 3}, true},
    {"all_layers_flat", {0, 1, 2, 3}, true},
    {"all_layers_flat_cache_off", {0, 1, 2, 3}, false},
}};

sdk::Body Merge(const schedule::Agent& agent, const std::vector<std::size_t>& layers) {
  sdk::Body merged = agent.layers[layers.front()].body;
  for (std::size_t i = 1; i < layers.size(); ++i) {
    const sdk::Body& body = agent.layers[layers[i]].body;
    const auto append = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(merged.files, body.files);
    append(merged.facts, body.facts);
    append(merged.inputs, body.inputs);
    append(merged.minimized, body.minimized);
    append(merged.attachments, body.attachments);
  }
  return merged;
}

/// What the world says to these layers around a time; what a layer within says is left out.
std::vector<sdk::Latch> LatchesAt(const Recording& recording,
                                  const std::vector<std::size_t>& layers, std::size_t sample) {
  const std::set<std::string_view> within = {"objects", "destination", "target"};
  std::vector<sdk::Latch> latches;
  for (const std::size_t layer : layers) {
    std::vector<const Event*> decisions;
    for (const Event& event : recording.layers[layer]) {
      if (!event.admission) decisions.push_back(&event);
    }
    const Event& event = *decisions[decisions.size() * (2 * sample + 1) / 40];
    for (const sdk::Latch& latch : event.latches) {
      const bool said_within = layer != layers.back() && within.contains(latch.port);
      const bool known = std::any_of(latches.begin(), latches.end(),
                                     [&](const auto& other) { return other.port == latch.port; });
      if (said_within || known) continue;
      latches.push_back(latch);
      latches.back().version = sample + 1;
    }
  }
  return latches;
}

void Ablations(benchmark::State& state) {
  const Ablation& ablation = kAblations[static_cast<std::size_t>(state.range(0))];
  state.SetLabel(std::string(ablation.name));
  Recording& recording = TheRecording();
  auto agent = MakeAgent("scenario3.xml", recording.registry, recording.symbols, 1);
  if (!agent) return state.SkipWithError("cannot assemble scenario3.xml");
  const auto made = recording.registry.MakeReasoner("pttp");
  sdk::Reasoner& reasoner = *made.object;
  logic::Diagnostics diagnostics;
  const char* flag = ablation.cache ? "true" : "false";
  const std::array<sdk::Parameters::Given, 3> given{
      {{"cache_attachments", flag, {}}, {"cache_decisions", flag, {}}, {"tables", flag, {}}}};
  const auto parameters =
      sdk::Parameters::Check(reasoner.parameters(), given, "pttp", {}, diagnostics);
  const sdk::Body body = Merge(*agent, ablation.layers);
  if (!reasoner.Load(body, parameters, recording.symbols).empty()) {
    return state.SkipWithError("the merged theory is not valid");
  }
  sdk::Budget budget;
  budget.inferences = 1'000'000;
  budget.depth = 160;
  sdk::Decision decision;
  Sample millis;
  Sample inferences;
  int undecided = 0;
  for (auto _ : state) {
    for (std::size_t sample = 0; sample < 20; ++sample) {
      const auto latches = LatchesAt(recording, ablation.layers, sample);
      const double start = ThreadSeconds();
      reasoner.Decide(latches, budget, decision);
      millis.Add((ThreadSeconds() - start) * 1e3);
      inferences.Add(static_cast<double>(decision.statistics.inferences));
      if (decision.status == sdk::Status::kUnknown) ++undecided;
    }
  }
  millis.Report("ms", state);
  inferences.Report("inf", state);
  state.counters["undecided_of_20"] = undecided;
}
BENCHMARK(Ablations)
    ->DenseRange(0, static_cast<int>(kAblations.size()) - 1)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latchwork

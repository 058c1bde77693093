// SPDX-License-Identifier: BSD-3-Clause
//
// What the four layers of the office agent decide in scenario 3, another floor: the latches of a
// run are recorded, then every layer goes through its cycles again, timed one by one, with its
// theory in the prover and with its program in the Icarus interpreter.
#include <benchmark/benchmark.h>

#include <vector>

#include "tests/bench/cpu_clock.h"
#include "tests/bench/recording.h"

namespace latchwork {
namespace {

void LayerDecides(benchmark::State& state) {
  Recording& recording = TheRecording();
  const bool is_program = state.range(1) == 1;
  auto agent = MakeAgent("scenario3.xml", recording.registry, recording.symbols, 1,
                         is_program ? "icarus.xml" : "");
  if (!agent) return state.SkipWithError("cannot assemble scenario3.xml");
  const auto layer = static_cast<std::size_t>(state.range(0));
  sdk::Reasoner& reasoner = *agent->layers[layer].reasoner;
  state.SetLabel(agent->description.layers[layer].name + (is_program ? " icarus" : " pttp"));
  Sample micros;
  Sample admission_micros;
  Sample inferences;
  sdk::Decision decision;
  std::vector<sdk::Refusal> refused;
  for (auto _ : state) {
    for (const Event& event : recording.layers[layer]) {
      refused.clear();
      const double start = ThreadSeconds();
      if (event.admission) {
        reasoner.Admit(event.latches, event.port, event.batch, event.budget, refused);
      } else {
        reasoner.Decide(event.latches, event.budget, decision);
      }
      const double taken = (ThreadSeconds() - start) * 1e6;
      (event.admission ? admission_micros : micros).Add(taken);
      if (!event.admission) inferences.Add(static_cast<double>(decision.statistics.inferences));
    }
  }
  micros.Report("us", state);
  if (!admission_micros.empty()) admission_micros.Report("admit_us", state);
  inferences.Report("inf", state);
}
BENCHMARK(LayerDecides)
    ->ArgsProduct({{0, 1, 2, 3}, {0, 1}})
    ->ArgNames({"layer", "program"})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latchwork

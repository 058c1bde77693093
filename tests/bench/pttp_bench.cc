// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "latchwork/logic/tptp.h"
#include "tests/reasoners/pttp/avoid_theory.h"
#include "tests/reasoners/pttp/ladder.h"

namespace latchwork::pttp {
namespace {

void BenchAvoid(benchmark::State& state) {
  AgentMind mind("avoid_bench", kAvoidTheory);
  LoadAvoid(mind);
  std::vector<std::vector<logic::Fact>> readings;
  for (int tick = 0; tick < 16; ++tick) {
    SenseAvoid(mind, tick);
    readings.push_back(mind.latches[1].facts);
  }
  std::size_t tick = 0;
  std::uint64_t inferences = 0;
  for (auto _ : state) {
    mind.latches[1].facts = readings[tick++ % readings.size()];
    ++mind.latches[1].version;
    inferences += mind.Decide().statistics.inferences;
  }
  state.counters["inferences"] =
      benchmark::Counter(static_cast<double>(inferences), benchmark::Counter::kAvgIterations);
}
BENCHMARK(BenchAvoid);

void BenchPlan(benchmark::State& state) {
  AgentMind mind("plan_bench", kItinerary);
  LoadLadder(mind, 125);
  mind.Latch(1, {"curr_landmark(a50)"});
  mind.Latch(2, {state.range(0) != 0 ? "goal(a75)" : "goal(island)"});
  std::uint64_t inferences = 0;
  for (auto _ : state) {
    ++mind.latches[1].version;
    inferences += mind.Decide().statistics.inferences;
  }
  state.SetLabel(std::string(Name(mind.decision.status)));
  state.counters["inferences"] =
      benchmark::Counter(static_cast<double>(inferences), benchmark::Counter::kAvgIterations);
}
BENCHMARK(BenchPlan)->Arg(1)->Arg(0);

}  // namespace
}  // namespace latchwork::pttp

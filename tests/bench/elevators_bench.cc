// SPDX-License-Identifier: BSD-3-Clause
//
// Plans in the elevator domain of layer 2, by the length of the shortest one.
#include <benchmark/benchmark.h>

#include <string>

#include "tests/bench/cpu_clock.h"
#include "tests/reasoners/pttp/tower.h"

namespace latchwork::pttp {
namespace {

/// A plan of so many actions through a tower; the elevators stand elsewhere in every cycle.
void PlanInTower(benchmark::State& state, const char* states) {
  const Tower tower(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  AgentMind mind("elevator_plan", kPlanTo);
  mind.Parameter("states", states);
  LoadElevators(mind);
  EnterTower(mind, tower);
  mind.budget.depth = 400;
  mind.budget.inferences = 10'000'000;
  Sample millis;
  int cycle = 0;
  for (auto _ : state) {
    mind.Latch(1, tower.Elevators(cycle++));
    const double start = ThreadSeconds();
    mind.Decide();
    millis.Add((ThreadSeconds() - start) * 1e3);
  }
  millis.Report("ms", state);
  state.SetLabel(std::string(sdk::Name(mind.decision.status)));
  state.counters["elevators"] = tower.elevators();
  state.counters["inferences"] = static_cast<double>(mind.decision.statistics.inferences);
}
void ElevatorPlan(benchmark::State& state) { PlanInTower(state, "true"); }

void PlanSizes(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"steps", "bank"})->Unit(benchmark::kMillisecond);
  for (int steps = 4; steps <= 12; ++steps) bench->Args({steps, 1});
  for (const int steps : {12, 20, 30}) {
    for (const int bank : {1, 2, 3}) {
      if (steps > 12 || bank > 1) bench->Args({steps, bank});
    }
  }
}
BENCHMARK(ElevatorPlan)->Apply(PlanSizes);

void ElevatorPlanBySearch(benchmark::State& state) { PlanInTower(state, "false"); }
BENCHMARK(ElevatorPlanBySearch)->Apply(PlanSizes);

}  // namespace
}  // namespace latchwork::pttp

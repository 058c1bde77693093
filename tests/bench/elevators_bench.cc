// SPDX-License-Identifier: BSD-3-Clause
//
// Plans in the elevator domain of layer 2, by the length of the shortest one.
#include <benchmark/benchmark.h>

#include <string>

#include "tests/bench/cpu_clock.h"
#include "tests/reasoners/pttp/tower.h"

namespace latchwork::pttp {
namespace {

/// A plan of so many actions through a tower; one elevator stands elsewhere in every cycle.
void ElevatorPlan(benchmark::State& state) {
  const Tower tower(static_cast<int>(state.range(0)));
  AgentMind mind("elevator_plan", kPlanTo);
  LoadElevators(mind);
  EnterTower(mind, tower);
  mind.budget.depth = 400;
  mind.budget.inferences = 10'000'000;
  Sample millis;
  int cycle = 0;
  for (auto _ : state) {
    auto elevators = tower.Elevators();
    elevators.back() = fmt::format("elevator_at(e{}, {})", tower.elevators - 1,
                                   tower.elevators * Tower::kFloors - 1 - cycle++ % 2);
    mind.Latch(1, elevators);
    const double start = ThreadSeconds();
    mind.Decide();
    millis.Add((ThreadSeconds() - start) * 1e3);
  }
  millis.Report("ms", state);
  state.SetLabel(std::string(sdk::Name(mind.decision.status)));
  state.counters["elevators"] = tower.elevators;
  state.counters["inferences"] = static_cast<double>(mind.decision.statistics.inferences);
}
BENCHMARK(ElevatorPlan)
    ->ArgName("steps")
    ->DenseRange(4, 12)
    ->Arg(20)
    ->Arg(30)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

#include "reasoners/circumscription/engine/engine.h"
#include "tests/bench/cpu_clock.h"
#include "tests/reasoners/circumscription/robot_theory.h"

namespace latchwork::circumscription {
namespace {

/// Control cycles of a robot: new latches, 20 cautious queries. Arguments: sonars, and how many of
/// a hundred are suspect. Microseconds of processor time for each cycle; the clock itself, read
/// twice a cycle, is in p50, p99 and max but not in the time of an iteration.
void BenchCycle(benchmark::State& state) {
  constexpr std::size_t kCycles = 4096;
  const RobotTheory robot(static_cast<int>(state.range(0)));
  Dice dice(7);
  std::vector<std::vector<Literal>> cycles;
  for (std::size_t i = 0; i < kCycles; ++i) {
    cycles.push_back(robot.Latches(dice, static_cast<int>(state.range(1))));
  }
  Engine engine(robot.theory);
  Sample sample;
  std::size_t cycle = 0;
  std::size_t yes = 0;
  const auto run = [&](const std::vector<Literal>& latches) {
    engine.SetLatches(latches);
    for (const std::vector<Literal>& query : robot.queries) {
      yes += engine.EntailsAlways(query).verdict == Verdict::kYes ? 1U : 0U;
    }
  };
  for (std::size_t i = 0; i < kCycles; i += 16) run(cycles[i]);
  for (auto _ : state) run(cycles[cycle++ % kCycles]);
  for (const auto& latches : cycles) {
    const double start = ThreadSeconds();
    run(latches);
    sample.Add(1e6 * (ThreadSeconds() - start));
  }
  benchmark::DoNotOptimize(yes);
  const EngineStatistics statistics = engine.statistics();
  sample.Report("us", state);
  state.counters["certified"] =
      static_cast<double>(statistics.certified) / static_cast<double>(statistics.cycles);
  state.counters["sat_calls"] =
      static_cast<double>(statistics.sat_calls) / static_cast<double>(statistics.cycles);
  state.counters["learnt"] = static_cast<double>(statistics.learnt);
}
BENCHMARK(BenchCycle)
    ->Name("circumscription_cycle")
    ->ArgNames({"sonars", "suspect"})
    ->Args({24, 0})
    ->Args({24, 15})
    ->Args({48, 15})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace latchwork::circumscription

// SPDX-License-Identifier: BSD-3-Clause
//
// What the office agent costs: a decision of layer 0, and the whole agent against the clock of its
// world.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/schedule/lockstep.h"
#include "latchwork/sdk/random.h"
#include "tests/bench/cpu_clock.h"
#include "tests/bench/office_agent.h"

namespace latchwork {
namespace {

using Clock = std::chrono::steady_clock;

/// Sonar batches of a ring that turns in a furnished room; no two cycles hear the same.
class SonarRing {
 public:
  SonarRing(int sonars, logic::SymbolTable& symbols)
      : sonars_(sonars),
        reading_(symbols.Intern("sonar_reading")),
        silence_(symbols.Intern("no_echo")),
        noise_(7, "bench sonar") {}

  void Fill(std::uint64_t cycle, sdk::Latch& latch) const {
    latch.facts.clear();
    ++latch.version;
    for (int sonar = 0; sonar < sonars_; ++sonar) {
      const double angle =
          2 * std::numbers::pi * (sonar + 0.01 * static_cast<double>(cycle)) / sonars_;
      const double gap = 1.2 + 0.9 * std::cos(2 * angle) +
                         noise_.Between(-0.02, 0.02, cycle, static_cast<std::uint64_t>(sonar));
      const logic::Term number = logic::Term::Integer(sonar);
      if (noise_.Uniform(cycle, static_cast<std::uint64_t>(1000 + sonar)) < 0.02) {
        latch.facts.emplace_back(silence_, std::initializer_list<logic::Term>{number});
      } else {
        latch.facts.emplace_back(
            reading_, std::initializer_list<logic::Term>{number, logic::Term::Real(gap)});
      }
    }
  }

 private:
  int sonars_;
  logic::Symbol reading_;
  logic::Symbol silence_;
  sdk::RandomStream noise_;
};

sdk::Latch RobotLatch(int sonars, logic::SymbolTable& symbols) {
  sdk::Latch latch{"robot", {}, 1};
  latch.facts.push_back({symbols.Intern("robot_radius"), {logic::Term::Real(0.25)}});
  for (int sonar = 0; sonar < sonars; ++sonar) {
    const double angle =
        std::remainder(2 * std::numbers::pi * sonar / sonars, 2 * std::numbers::pi);
    latch.facts.push_back({symbols.Intern("sonar_direction"),
                           {logic::Term::Integer(sonar), logic::Term::Real(angle)}});
  }
  return latch;
}

sdk::Latch PushLatch(logic::SymbolTable& symbols) {
  const logic::Term pusher = logic::Term::Constant(symbols.Intern("push_object"));
  return {"objects",
          {{symbols.Intern("object"), {pusher}},
           {symbols.Intern("distance"), {pusher, logic::Term::Real(1.0)}},
           {symbols.Intern("direction"), {pusher, logic::Term::Real(3.0)}}},
          1};
}

/// Layer 0 with new readings in every cycle and a push from above.
void AvoidDecides(benchmark::State& state) {
  const int sonars = static_cast<int>(state.range(0));
  const plugin::Registry registry = MakeRegistry();
  logic::SymbolTable symbols;
  std::optional<schedule::Agent> agent = MakeAgent("scenario1.xml", registry, symbols, 1);
  if (!agent) return state.SkipWithError("cannot assemble scenario1.xml");
  sdk::Reasoner& reasoner = *agent->layers[0].reasoner;
  const SonarRing ring(sonars, symbols);
  std::vector<sdk::Latch> latches = {
      {"sonar", {}, 0}, RobotLatch(sonars, symbols), PushLatch(symbols)};
  sdk::Budget budget;
  budget.inferences = agent->description.layers[0].reasoner.inferences;
  budget.depth = agent->description.layers[0].reasoner.depth;
  sdk::Decision decision;
  Sample micros;
  std::uint64_t cycle = 0;
  for (auto _ : state) {
    ring.Fill(++cycle, latches[0]);
    const double start = ThreadSeconds();
    reasoner.Decide(latches, budget, decision);
    const double taken = ThreadSeconds() - start;
    state.SetIterationTime(taken);
    micros.Add(taken * 1e6);
  }
  micros.Report("us", state);
  state.counters["inferences"] = static_cast<double>(decision.statistics.inferences);
}
BENCHMARK(AvoidDecides)->Arg(16)->Arg(24)->UseManualTime()->Unit(benchmark::kMicrosecond);

/// The first minute of a scenario, all four layers, world included. x_real_time: simulated over
/// wall time.
void OfficeAgentRuns(benchmark::State& state) {
  const std::string file = "scenario" + std::to_string(state.range(0)) + ".xml";
  const plugin::Registry registry = MakeRegistry();
  double simulated = 0;
  double wall = 0;
  for (auto _ : state) {
    logic::SymbolTable symbols;
    std::optional<schedule::Agent> agent = MakeAgent(file, registry, symbols, 1);
    if (!agent) return state.SkipWithError("cannot assemble the agent");
    schedule::LockstepOptions options;
    options.max_ticks = 600;
    schedule::Lockstep lockstep(std::move(*agent), options);
    const auto start = Clock::now();
    const schedule::RunResult result = lockstep.Run();
    const std::chrono::duration<double> taken = Clock::now() - start;
    state.SetIterationTime(taken.count());
    simulated += static_cast<double>(result.ticks) * 0.1;
    wall += taken.count();
  }
  state.counters["x_real_time"] = simulated / wall;
}
BENCHMARK(OfficeAgentRuns)
    ->Arg(1)
    ->Arg(2)
    ->Arg(3)
    ->UseManualTime()
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latchwork

// SPDX-License-Identifier: BSD-3-Clause
//
// What an Icarus cycle takes: per clause evaluated, per level of objective, conditions and means,
// and per match with a fact of memory. All sensors are asked anew in every cycle.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "reasoners/icarus/tools/trace_entry.h"
#include "tests/reasoners/icarus/trees.h"

namespace latchwork::icarus::testing {
namespace {

benchmark::Counter PerUnit(std::uint64_t units) {
  return {static_cast<double>(units), benchmark::Counter::kIsRate | benchmark::Counter::kInvert};
}

void Run(benchmark::State& state, const std::string& program, const std::string& unit,
         std::uint64_t units) {
  TreeRun run(program);
  if (run.Cycle().acts.size() != 1) return state.SkipWithError("the tree does not act");
  std::uint64_t clauses = 0;
  std::uint64_t cycles = 0;
  for (auto _ : state) {
    clauses += run.Cycle().clauses;
    ++cycles;
  }
  state.counters["per_clause"] = PerUnit(clauses);
  if (!unit.empty()) state.counters["per_" + unit] = PerUnit(units * cycles);
}

/// So many conditions, one after the other.
void IcarusConditions(benchmark::State& state) {
  Run(state, FlatTree(static_cast<std::size_t>(state.range(0))), "", 0);
}
BENCHMARK(IcarusConditions)->Arg(10)->Arg(100)->Arg(1000);

/// Trees of so many nodes, five to a level as a behaviour tree has them: fallback, goal, two
/// conditions, sequence. The second argument: whether they are asked of a parameter.
void IcarusLevels(benchmark::State& state) {
  const auto levels = static_cast<std::size_t>(state.range(0) / 5);
  Run(state, LevelTree(levels, state.range(1) == 1), "level", levels);
}
BENCHMARK(IcarusLevels)->ArgsProduct({{10, 100, 1000}, {0, 1}})->ArgNames({"nodes", "parameters"});

/// Puts events into words.
class DescribingSink : public EventSink {
 public:
  explicit DescribingSink(TreeRun& run)
      : describer_(run.file.program, run.interpreter.TopSource(run.top),
                   run.interpreter.TopVariables(run.top), run.names) {}
  void OnEvent(const Event& event) override {
    benchmark::DoNotOptimize(TraceLine(describer_.Describe(event)));
  }

 private:
  EventDescriber describer_;
};

/// Takes note of events, and does nothing with them.
class CountingSink : public EventSink {
 public:
  void OnEvent(const Event& event) override { sum_ += event.number; }
  std::uint64_t sum() const { return sum_; }

 private:
  std::uint64_t sum_ = 0;
};

/// The same trees, with parameters, while somebody is told of every event. The second argument:
/// whether events are put into words, as for `icarus trace`.
void IcarusTracedLevels(benchmark::State& state) {
  const auto levels = static_cast<std::size_t>(state.range(0) / 5);
  TreeRun run(LevelTree(levels, true));
  CountingSink counting;
  DescribingSink describing(run);
  run.interpreter.SetSink(state.range(1) == 1 ? static_cast<EventSink*>(&describing) : &counting);
  std::uint64_t cycles = 0;
  for (auto _ : state) {
    run.Cycle();
    ++cycles;
  }
  benchmark::DoNotOptimize(counting.sum());
  state.counters["per_level"] = PerUnit(levels * cycles);
}
BENCHMARK(IcarusTracedLevels)->ArgsProduct({{10, 100, 1000}, {0, 1}})->ArgNames({"nodes", "words"});

/// One hundred matches with a memory of so many facts.
void IcarusMatches(benchmark::State& state) {
  Run(state, ManyFacts(static_cast<std::size_t>(state.range(0)), 100), "match", 100);
}
BENCHMARK(IcarusMatches)->Arg(100)->Arg(300)->Arg(3000);

}  // namespace
}  // namespace latchwork::icarus::testing

// SPDX-License-Identifier: BSD-3-Clause
//
// What an Icarus cycle takes: per clause evaluated, per level of objective, conditions and means,
// and per match with a fact of memory. All sensors are asked anew in every cycle.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <string>

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

/// One hundred matches with a memory of so many facts.
void IcarusMatches(benchmark::State& state) {
  Run(state, ManyFacts(static_cast<std::size_t>(state.range(0)), 100), "match", 100);
}
BENCHMARK(IcarusMatches)->Arg(100)->Arg(300)->Arg(3000);

}  // namespace
}  // namespace latchwork::icarus::testing

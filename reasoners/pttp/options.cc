// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/options.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/sdk/specs.h"
#include "reasoners/pttp/strategies/schedule.h"

namespace latchwork::pttp {
namespace {

using sdk::BooleanParameter;
using sdk::ChoiceParameter;
using sdk::IntegerParameter;
using sdk::RealParameter;

constexpr const char* kSchedule = "schedule";

sdk::ParameterSpec StrategyOption() {
  std::vector<std::string> names{kSchedule};
  for (const NamedStrategy& strategy : Strategies()) names.emplace_back(strategy.name);
  return ChoiceParameter(
      "strategy", std::move(names),
      "which search to make; `schedule`: one after the other, as suits the problem");
}

}  // namespace

std::span<const sdk::ParameterSpec> LayerOptions() {
  static const std::vector<sdk::ParameterSpec> table{
      BooleanParameter("unique_names", false,
                       "distinct constants, and compound terms of distinct functions, are unequal"),
      BooleanParameter(
          "equality_axioms", false,
          "equations that clauses conclude are used everywhere; else `=` is identity after "
          "arithmetic"),
      BooleanParameter("cache_attachments", true,
                       "an attachment is called once per cycle for the same inputs"),
      BooleanParameter("cache_decisions", true,
                       "what was decided of a goal stands while no fact that it can see changes"),
      BooleanParameter(
          "tables", true,
          "goals whose clauses allow it are answered from tables instead of by search"),
      BooleanParameter(
          "states", true,
          "plans are searched among the states that situations have in common, where the rules "
          "allow it"),
      BooleanParameter("reorder", true,
                       "facts with a bound argument are looked up before rules are followed"),
      IntegerParameter(
          "consistency_inferences", "2000", 0, 1e9,
          "what a cycle spends on finding that body and latches contradict each other; 0: "
          "nothing"),
  };
  return table;
}

std::span<const sdk::ParameterSpec> ProblemOptions() {
  static const std::vector<sdk::ParameterSpec> table{
      RealParameter("time", "10", 0.001, 1e6, "s",
                    "CPU time to spend, reading included, of all threads together"),
      IntegerParameter("memory", "4096", 0, 1U << 24U, "memory to use; 0: no limit", "MB"),
      IntegerParameter("inferences", "0", 0, 1e15, "inferences to spend; 0: no limit"),
      IntegerParameter("depth", "1000000", 1, 1e6, "deepest path to search"),
      StrategyOption(),
      BooleanParameter("saturation", true,
                       "the schedule has superposition besides connection tableaux"),
      IntegerParameter(
          "threads", "1", 1, 64,
          "strategies of the schedule that run at the same time; which of them ends the "
          "attempt is then a matter of chance"),
  };
  return table;
}

ProverOptions OptionsFrom(const sdk::Parameters& values) {
  ProverOptions options;
  options.cpu_seconds = values.Real("time");
  const auto megabytes = static_cast<std::size_t>(values.Integer("memory"));
  if (megabytes != 0) options.memory_bytes = megabytes << 20U;
  const auto inferences = static_cast<std::uint64_t>(values.Integer("inferences"));
  options.budget.inferences =
      inferences == 0 ? std::numeric_limits<std::uint64_t>::max() : inferences;
  options.budget.depth = static_cast<std::uint32_t>(values.Integer("depth"));
  options.strategy = values.Text("strategy");
  options.saturation = values.Boolean("saturation");
  options.threads = static_cast<unsigned>(values.Integer("threads"));
  return options;
}

}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/options.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "reasoners/pttp/strategies/schedule.h"

namespace latchwork::pttp {
namespace {

using Type = sdk::ParameterType;

constexpr const char* kSchedule = "schedule";

sdk::ParameterSpec Flag(std::string name, bool by_default, std::string help) {
  return {.name = std::move(name),
          .type = Type::kBoolean,
          .default_value = by_default ? "true" : "false",
          .unit = "",
          .help = std::move(help),
          .choices = {}};
}

sdk::ParameterSpec Number(std::string name, Type type, std::string by_default, double minimum,
                          double maximum, std::string unit, std::string help) {
  return {.name = std::move(name),
          .type = type,
          .default_value = std::move(by_default),
          .minimum = minimum,
          .maximum = maximum,
          .unit = std::move(unit),
          .help = std::move(help),
          .choices = {}};
}

sdk::ParameterSpec StrategyOption() {
  std::vector<std::string> names{kSchedule};
  for (const NamedStrategy& strategy : Strategies()) names.emplace_back(strategy.name);
  return {.name = "strategy",
          .type = Type::kText,
          .default_value = kSchedule,
          .unit = "",
          .help = "which search to make; `schedule`: one after the other, as suits the problem",
          .choices = names};
}

}  // namespace

std::span<const sdk::ParameterSpec> LayerOptions() {
  static const std::vector<sdk::ParameterSpec> table{
      Flag("unique_names", false,
           "distinct constants, and compound terms of distinct functions, are unequal"),
      Flag("equality_axioms", false,
           "equations that clauses conclude are used everywhere; else `=` is identity after "
           "arithmetic"),
      Flag("cache_attachments", true, "an attachment is called once per cycle for the same inputs"),
      Flag("cache_decisions", true,
           "what was decided of a goal stands while no fact that it can see changes"),
      Flag("tables", true,
           "goals whose clauses allow it are answered from tables instead of by search"),
      Flag("states", true,
           "plans are searched among the states that situations have in common, where the rules "
           "allow it"),
      Flag("reorder", true, "facts with a bound argument are looked up before rules are followed"),
      Number("consistency_inferences", Type::kInteger, "2000", 0, 1e9, "",
             "what a cycle spends on finding that body and latches contradict each other; 0: "
             "nothing"),
  };
  return table;
}

std::span<const sdk::ParameterSpec> ProblemOptions() {
  static const std::vector<sdk::ParameterSpec> table{
      Number("time", Type::kReal, "10", 0.001, 1e6, "s",
             "CPU time to spend, reading included, of all threads together"),
      Number("memory", Type::kInteger, "4096", 0, 1U << 24U, "MB", "memory to use; 0: no limit"),
      Number("inferences", Type::kInteger, "0", 0, 1e15, "", "inferences to spend; 0: no limit"),
      Number("depth", Type::kInteger, "1000000", 1, 1e6, "", "deepest path to search"),
      StrategyOption(),
      Flag("saturation", true, "the schedule has superposition besides connection tableaux"),
      Number("threads", Type::kInteger, "1", 1, 64, "",
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

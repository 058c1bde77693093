// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/icarus_options.h"

#include <string>
#include <utility>
#include <vector>

#include "reasoners/icarus/learning/layer_learning.h"

namespace latchwork::icarus {
namespace {

sdk::ParameterSpec Choice(std::string name, std::vector<std::string> choices, std::string help) {
  return {.name = std::move(name),
          .type = sdk::ParameterType::kText,
          .default_value = choices.front(),
          .unit = "",
          .help = std::move(help),
          .choices = choices};
}

sdk::ParameterSpec Flag(std::string name, std::string help) {
  return {.name = std::move(name),
          .type = sdk::ParameterType::kBoolean,
          .default_value = "false",
          .unit = "",
          .help = std::move(help),
          .choices = {}};
}

std::vector<sdk::ParameterSpec> MakeOptions() {
  std::vector<sdk::ParameterSpec> options = {
      Choice("acts", {"first", "all", "value"}, "the acts that leave a skill"),
      Choice("expand", {"all", "first", "best"}, "the means that are asked"),
      {.name = "means",
       .type = sdk::ParameterType::kInteger,
       .default_value = "1",
       .minimum = 1,
       .maximum = 1e6,
       .unit = "",
       .help = "how many means are asked, where not all are",
       .choices = {}},
      Flag("restart", "a finished sequence starts again"),
      Flag("full", "a cycle goes on after its first act"),
      Choice("faults", {"false", "abort-cycle", "stop"},
             "what a fault does: its clause is False; the cycle fails; that cycle and all "
             "after it fail")};
  for (sdk::ParameterSpec& of : LayerLearning::Parameters()) options.push_back(std::move(of));
  return options;
}

}  // namespace

std::span<const sdk::ParameterSpec> LayerOptions() {
  static const std::vector<sdk::ParameterSpec> table = MakeOptions();
  return table;
}

RunOptions OptionsFrom(const sdk::Parameters& values) {
  RunOptions options;
  const std::string& acts = values.Text("acts");
  if (acts == "all") options.acts = ActMode::kAll;
  if (acts == "value") options.acts = ActMode::kValue;
  const std::string& expand = values.Text("expand");
  if (expand == "first") options.expansion = Expansion::kFirst;
  if (expand == "best") options.expansion = Expansion::kBest;
  options.means = static_cast<std::size_t>(values.Integer("means"));
  options.restart = values.Boolean("restart");
  options.lazy = !values.Boolean("full");
  const std::string& faults = values.Text("faults");
  if (faults == "abort-cycle") options.faults = FaultMode::kAbortCycle;
  if (faults == "stop") options.faults = FaultMode::kStop;
  return options;
}

}  // namespace latchwork::icarus

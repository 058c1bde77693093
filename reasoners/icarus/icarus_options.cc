// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/icarus_options.h"

#include <string>
#include <utility>
#include <vector>

#include "latchwork/sdk/specs.h"
#include "reasoners/icarus/learning/layer_learning.h"

namespace latchwork::icarus {
namespace {

using sdk::BooleanParameter;
using sdk::ChoiceParameter;

std::vector<sdk::ParameterSpec> MakeOptions() {
  std::vector<sdk::ParameterSpec> options = {
      ChoiceParameter("acts", {"first", "all", "value"}, "the acts that leave a skill"),
      ChoiceParameter("expand", {"all", "first", "best"}, "the means that are asked"),
      sdk::IntegerParameter("means", "1", 1, 1e6, "how many means are asked, where not all are"),
      BooleanParameter("restart", false, "a finished sequence starts again"),
      BooleanParameter("full", false, "a cycle goes on after its first act"),
      ChoiceParameter("faults", {"false", "abort-cycle", "stop"},
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

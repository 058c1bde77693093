// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/options.h"

#include <vector>

#include "latchwork/sdk/specs.h"
#include "reasoners/pttp/options.h"

namespace latchwork::circumscription {
namespace {

std::vector<sdk::ParameterSpec> MakeOptions() {
  std::vector<sdk::ParameterSpec> options{
      sdk::ChoiceParameter("mode", {"auto", "exact", "bounded"},
                           "how defaults are decided: `exact`, by the minimal models; `bounded`, "
                           "by proofs within the bound; `auto`: exact where the body allows it"),
      sdk::ChoiceParameter("entailment", {"cautious", "brave"},
                           "in exact decisions, what is concluded: what holds in all minimal "
                           "models, or in some")};
  for (const sdk::ParameterSpec& option : pttp::LayerOptions()) options.push_back(option);
  return options;
}

}  // namespace

std::span<const sdk::ParameterSpec> LayerOptions() {
  static const std::vector<sdk::ParameterSpec> options = MakeOptions();
  return options;
}

Mode ModeOf(const sdk::Parameters& parameters) {
  const std::string& mode = parameters.Text("mode");
  if (mode == "exact") return Mode::kExact;
  return mode == "bounded" ? Mode::kBounded : Mode::kAuto;
}

bool IsBrave(const sdk::Parameters& parameters) { return parameters.Text("entailment") == "brave"; }

}  // namespace latchwork::circumscription

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_EXPERIMENT_EXPERIMENT_H_
#define LATCHWORK_APPS_COMPARE_EXPERIMENT_EXPERIMENT_H_

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/process/limits.h"
#include "latchwork/logic/diagnostic.h"

namespace latchwork::compare {

/// A world and what to reach in it.
struct Scenario {
  std::string name;
  std::filesystem::path file;  ///< An agent file.
  logic::SourcePlace place{};  ///< Where the experiment names it.
};

/// What is compared: the agent of each scenario, changed.
struct Contender {
  std::string name;
  std::optional<std::filesystem::path> fragment;  ///< Overrides that come on top.
  std::vector<std::string> settings;              ///< PART.NAME=VALUE, after the fragment.
  std::uint64_t seed_offset = 0;  ///< Added to every seed: a control that meets other worlds.
  logic::SourcePlace place{};     ///< Where the experiment names it.
  std::vector<logic::SourcePlace> setting_places{};
};

/// What one run may use before it is ended.
using RunLimits = process::Limits;

/// Every contender in every scenario with every seed. The first contender is the one that the
/// others are compared with.
struct Experiment {
  std::string name;
  std::uint64_t first_seed = 1;
  std::uint64_t last_seed = 1;
  double level = 0.05;  ///< Of the tests, all together.
  RunLimits limits;
  std::vector<Scenario> scenarios;
  std::vector<Contender> contenders;
  logic::SourcePlace limits_place{};  ///< Of `memory`, or of the whole.
  std::string text{};                 ///< Of the file, for excerpts.
};

struct ExperimentFile {
  std::optional<Experiment> experiment;  ///< Only when `diagnostics` is empty.
  logic::Diagnostics diagnostics;
};

/// Reads and checks a file; all errors at once. Paths in it are relative to it.
ExperimentFile ReadExperiment(const std::filesystem::path& file);
ExperimentFile ReadExperimentText(std::string_view text, const std::filesystem::path& name);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_EXPERIMENT_EXPERIMENT_H_

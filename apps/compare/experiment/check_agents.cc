// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/experiment/check_agents.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "core/config/document.h"
#include "core/process/child_process.h"

namespace latchwork::compare {
namespace {

using Json = nlohmann::ordered_json;
using End = process::ChildResult::End;

/// Where a diagnostic stands that is of a <set>.
constexpr std::string_view kCommandLine = "command line";

std::vector<std::string> CheckingOf(const PlannedRun& run, const Launch& launch) {
  std::vector<std::string> words = launch.arguments;
  words.insert(words.end(), {"check", "--json"});
  for (std::size_t i = 1; i < run.arguments.size(); ++i) {
    if (run.arguments[i] == "--seed") {
      ++i;
    } else {
      words.push_back(run.arguments[i]);
    }
  }
  return words;
}

std::optional<logic::Diagnostics> ReadDiagnostics(const std::string& text) {
  const Json list = Json::parse(text, nullptr, false);
  if (!list.is_array()) return std::nullopt;
  logic::Diagnostics diagnostics;
  try {
    for (const Json& each : list) {
      diagnostics.push_back({{each.at("file"), each.at("line"), each.at("column")},
                             each.at("message"),
                             each.at("hint"),
                             each.value("excerpt", "")});
    }
  } catch (const Json::exception&) {
    return std::nullopt;
  }
  return diagnostics;
}

/// The <set> that a message names, or the agent.
logic::SourcePlace PlaceOf(const Contender& contender, const std::string& message) {
  for (std::size_t i = 0; i < contender.setting_places.size(); ++i) {
    const std::string name = contender.settings[i].substr(0, contender.settings[i].find('='));
    const std::size_t dot = name.rfind('.');
    const std::string part = name.substr(0, name.find('.'));
    if (message.find(name) != std::string::npos ||
        message.find('\'' + name.substr(dot + 1) + '\'') != std::string::npos ||
        message.find('\'' + part + '\'') != std::string::npos) {
      return contender.setting_places[i];
    }
  }
  return contender.place;
}

std::string WhyOf(const process::ChildResult& child) {
  switch (child.end) {
    case End::kTimedOut:
      return "the program needs more time to begin";
    case End::kSignalled:
      return fmt::format("the program was ended by signal {}", child.code);
    case End::kNotStarted:
      return "the program cannot be started: " + child.errors;
    default:
      return fmt::format("the program ended with exit code {}{}{}", child.code,
                         child.errors.empty() ? "" : ": ",
                         child.errors.substr(0, child.errors.find('\n')));
  }
}

class Checker {
 public:
  explicit Checker(const Experiment& experiment) : experiment_(experiment) {}

  /// What the program itself came to within the limits. False: no run can begin.
  bool TakeProgram(const process::ChildResult& child) {
    if (child.end == End::kStopped || (child.end == End::kExited && child.code == 0)) return true;
    Add({experiment_.limits_place,
         fmt::format("no run can begin within {} MB and {:g} s: {}", experiment_.limits.memory_mb,
                     experiment_.limits.wall_seconds, WhyOf(child)),
         R"(allow more, as in memory="4096MB" and wall="300s")", ""});
    return false;
  }

  /// An agent whose check crashes or takes too long is left to its runs: these are outcomes.
  void Take(const PlannedRun& run, const process::ChildResult& child) {
    auto told = child.end == End::kExited ? ReadDiagnostics(child.output) : std::nullopt;
    if (!told) return;
    const auto contender =
        std::ranges::find(experiment_.contenders, run.key.contender, &Contender::name);
    for (logic::Diagnostic& each : *told) {
      if (each.place.file == kCommandLine) each.place = PlaceOf(*contender, each.message);
      Add(std::move(each));
    }
  }

  logic::Diagnostics Finish() {
    for (logic::Diagnostic& each : diagnostics_) {
      logic::Diagnostics own = {each};
      config::Arrange({{experiment_.limits_place.file, experiment_.text}}, own);
      each = std::move(own.front());
    }
    return std::move(diagnostics_);
  }

 private:
  void Add(logic::Diagnostic diagnostic) {
    const auto& place = diagnostic.place;
    if (!known_.insert({place.file, place.line, place.column, diagnostic.message}).second) return;
    diagnostics_.push_back(std::move(diagnostic));
  }

  const Experiment& experiment_;
  std::set<std::tuple<std::string, std::uint32_t, std::uint32_t, std::string>> known_;
  logic::Diagnostics diagnostics_;
};

}  // namespace

logic::Diagnostics CheckAgents(const Experiment& experiment, const std::vector<PlannedRun>& runs,
                               const Launch& launch, const std::atomic<bool>& stop) {
  Checker checker(experiment);
  if (runs.empty()) return {};
  std::vector<std::string> version = launch.arguments;
  version.emplace_back("--version");
  if (!checker.TakeProgram(process::RunChild(launch.program, version, experiment.limits, stop))) {
    return checker.Finish();
  }
  std::set<std::vector<std::string>> checked;
  for (const PlannedRun& run : runs) {
    std::vector<std::string> words = CheckingOf(run, launch);
    if (stop || !checked.insert(words).second) continue;
    const auto child = process::RunChild(launch.program, words, experiment.limits, stop);
    if (child.end != End::kStopped) checker.Take(run, child);
  }
  return checker.Finish();
}

}  // namespace latchwork::compare

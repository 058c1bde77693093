// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/report/result_files.h"

#include <fmt/format.h>

#include <fstream>

#include "apps/compare/report/findings.h"
#include "apps/compare/report/ompl_log.h"
#include "apps/compare/storage/database.h"

namespace latchwork::compare {
namespace {

std::string WriteText(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text << std::flush;
  return stream ? "" : "cannot be written";
}

std::map<std::string, Building> BuildingsOf(const Experiment& experiment, const Origin& origin) {
  if (origin.launch.program.empty()) {
    std::map<std::string, Building> none;
    for (const Scenario& scenario : experiment.scenarios) none[scenario.name];
    return none;
  }
  const std::atomic<bool> never = false;
  return DrawBuildings(experiment, origin.launch, origin.stop == nullptr ? never : *origin.stop);
}

}  // namespace

WrittenResults WriteResultFiles(const std::filesystem::path& folder, const Experiment& experiment,
                                const std::map<RunKey, RunRecord>& records, const Origin& origin) {
  const Findings findings = Evaluate(experiment, records);
  WrittenResults written{ToText(experiment, findings), ""};
  const auto note = [&](const char* name, const std::string& problem) {
    if (problem.empty()) return;
    written.problems += fmt::format("{}: {}\n", (folder / name).string(), problem);
  };
  note("report.txt", WriteText(folder / "report.txt", written.report));
  const std::map<std::string, Building> buildings = BuildingsOf(experiment, origin);
  const ReportInput input{experiment, records, findings, buildings, origin.making};
  note("report.html", WriteText(folder / "report.html", ToHtml(input)));
  for (const Scenario& scenario : experiment.scenarios) {
    const std::string name = fmt::format("ompl-{}.log", scenario.name);
    note(name.c_str(), WriteText(folder / name, ToOmplLog(input, scenario.name)));
  }
  note("runs.csv", WriteText(folder / "runs.csv", ToCsv(records, experiment.limits)));
  note("results.sqlite", WriteResults(folder / "results.sqlite", records));
  note("timings.sqlite", WriteTimings(folder / "timings.sqlite", records));
  return written;
}

}  // namespace latchwork::compare

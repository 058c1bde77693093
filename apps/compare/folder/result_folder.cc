// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/folder/result_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace latchwork::compare {
namespace {

std::filesystem::path LogIn(const std::filesystem::path& folder) { return folder / "runs.jsonl"; }

std::filesystem::path Made(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  return folder;
}

}  // namespace

ResultFolder::ResultFolder(const Experiment& experiment, std::filesystem::path folder)
    : experiment_(experiment), folder_(std::move(folder)), log_(LogIn(Made(folder_))) {
  if (!log_.problem().empty()) {
    Stop(Trouble::Kind::kInput, log_.problem() + '\n');
  } else if (!log_.done().empty()) {
    Belong(ReadRunLog(LogIn(folder_)).runs, folder_);
  }
}

void ResultFolder::Stop(Trouble::Kind kind, std::string text) {
  if (trouble_.kind == Trouble::Kind::kNone) trouble_ = {kind, std::move(text)};
}

bool ResultFolder::Belong(const std::map<RunKey, RunRecord>& runs,
                          const std::filesystem::path& folder) {
  std::map<RunKey, std::string> commands;
  for (const PlannedRun& run : PlanRuns(experiment_)) commands[run.key] = CommandOf(run);
  const auto stranger = std::ranges::find_if(runs, [&](const auto& run) {
    const auto planned = commands.find(run.first);
    return planned == commands.end() || planned->second != run.second.command;
  });
  if (stranger == runs.end()) return true;
  Stop(Trouble::Kind::kInput,
       fmt::format("{}: holds a run that is not of this experiment: {}\n  use another folder, or "
                   "move this one away\n",
                   folder.string(), stranger->second.command));
  return false;
}

void ResultFolder::TakeOver(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(LogIn(folder))) {
    Stop(Trouble::Kind::kInput,
         fmt::format("{}: there is no runs.jsonl to take over\n", folder.string()));
    return;
  }
  const LoggedRuns other = ReadRunLog(LogIn(folder));
  if (!other.problem.empty()) {
    Stop(Trouble::Kind::kInput, other.problem + '\n');
    return;
  }
  if (!Belong(other.runs, folder)) return;
  for (const auto& [key, record] : other.runs) {
    if (!log_.done().contains(key) && !Keep(record)) return;
  }
}

std::vector<PlannedRun> ResultFolder::Missing(const Shard& shard) const {
  std::vector<PlannedRun> missing = PlanRuns(experiment_, shard);
  std::erase_if(missing, [&](const PlannedRun& run) { return log_.done().contains(run.key); });
  return missing;
}

bool ResultFolder::Keep(const RunRecord& record) {
  if (trouble_.kind != Trouble::Kind::kNone) return false;
  if (record.outcome == Outcome::kInvalid) {
    Stop(Trouble::Kind::kInput,
         fmt::format("a run cannot begin: {}\n  {}\n", record.command, record.message));
    return false;
  }
  if (!log_.Add(record)) Stop(Trouble::Kind::kWriting, log_.problem() + '\n');
  return trouble_.kind == Trouble::Kind::kNone;
}

std::string ResultFolder::WriteResults(const Origin& origin) {
  if (trouble_.kind != Trouble::Kind::kNone) return "";
  const LoggedRuns logged = ReadRunLog(LogIn(folder_));
  if (!logged.problem.empty()) {
    Stop(Trouble::Kind::kWriting, logged.problem + '\n');
    return "";
  }
  WrittenResults written = WriteResultFiles(folder_, experiment_, logged.runs, origin);
  if (!written.problems.empty()) Stop(Trouble::Kind::kWriting, std::move(written.problems));
  return trouble_.kind == Trouble::Kind::kNone ? std::move(written.report) : "";
}

}  // namespace latchwork::compare

// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/runs/fork_server.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <utility>

#include "apps/compare/runs/serve_runs.h"

namespace latchwork::compare {
namespace {

using namespace std::chrono_literals;
using Reply = process::Companion::Reply;

constexpr auto kGrace = 60s;   // To load, to judge: beyond what the run may take.
constexpr auto kGoodbye = 2s;  // To end its run.

std::string EndOf(int status) {
  if (WIFSIGNALED(status)) return fmt::format("was ended by signal {}", WTERMSIG(status));
  if (WEXITSTATUS(status) == process::kCannotExecute) return "cannot be executed";
  return fmt::format("ended with exit code {}", WEXITSTATUS(status));
}

/// "", or ": " and the last line.
std::string Said(std::string_view errors) {
  while (errors.ends_with('\n')) errors.remove_suffix(1);
  if (errors.empty()) return "";
  const std::size_t before = errors.rfind('\n');
  return fmt::format(": {}", before == std::string_view::npos ? errors : errors.substr(before + 1));
}

}  // namespace

ForkServer::ForkServer(const Launch& launch)
    : program_(launch.program), arguments_(launch.arguments) {
  arguments_.emplace_back(kForkServerCommand);
}

void ForkServer::Begin(const Task& task) {
  task_ = task;
  const auto time = std::chrono::duration<double>(std::min(task.limits.wall_seconds, 1e8));
  last_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(time) + kGrace;
  const std::string line = ToText(task) + '\n';
  const process::Companion::Patience patience{last_};
  if (process_.Send(line, patience)) return;
  is_ready_ = false;
  if (process_.Start(program_, arguments_, process::kAnyMemory)) process_.Send(line, patience);
}

std::optional<RunRecord> ForkServer::Wait(Clock::duration time) {
  const Clock::time_point end = std::min(Clock::now() + time, last_);
  std::string line;
  while (true) {
    const Reply reply = process_.ReadLine(line, {end});
    if (reply == Reply::kEnded) return Lost(EndOf(process_.status()));
    if (reply != Reply::kLine) {
      return Clock::now() < last_ ? std::nullopt : std::optional(Lost("does not answer"));
    }
    if (is_ready_ || line != kReady) return Hear(line);
    is_ready_ = true;
  }
}

std::optional<RunRecord> ForkServer::Hear(const std::string& line) {
  auto record = FromLine(line);
  if (!is_ready_ || !record || record->key != task_->run.key) return Lost("answers nonsense");
  task_.reset();
  return record;
}

/// One that never was ready cannot begin any run; one that dies is as a run that does.
RunRecord ForkServer::Lost(const std::string& why) {
  process_.Kill();
  RunRecord record;
  record.key = task_->run.key;
  record.command = CommandOf(task_->run);
  record.outcome = is_ready_ ? Outcome::kCrashed : Outcome::kInvalid;
  record.message = fmt::format("the fork server {}{}", why, Said(process_.errors()));
  task_.reset();
  return record;
}

void ForkServer::End() {
  process_.End(kGoodbye);
  task_.reset();
}

}  // namespace latchwork::compare

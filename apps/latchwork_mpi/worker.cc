// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork_mpi/worker.h"

#include <atomic>
#include <chrono>
#include <future>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "apps/compare/dispatch/dispatcher.h"

namespace latchwork::mpi {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kBeat = 1s;  ///< Between two words from a worker that is busy.
constexpr auto kPause = 50ms;
constexpr auto kPoll = 500us;

/// The run at hand, made on a thread of its own: the other one speaks to the master.
class Run {
 public:
  Run(compare::PlannedRun run, compare::RunCommand command)
      : run_(std::move(run)), command_(std::move(command)) {}
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  ~Run() { stop_ = true; }

  /// Whether it ended within that time.
  bool Wait(Clock::duration time) const {
    return record_.wait_for(time) == std::future_status::ready;
  }
  /// Once, when it has ended.
  std::optional<compare::RunRecord> Take() { return record_.get(); }

 private:
  compare::PlannedRun run_;
  compare::RunCommand command_;
  std::atomic<bool> stop_ = false;
  std::future<std::optional<compare::RunRecord>> record_ =
      std::async(std::launch::async, [this] { return compare::MakeRun(run_, command_, stop_); });
};

std::optional<std::string> Ask(MpiLink& link, std::string text, double endurance_seconds) {
  link.Send(0, std::move(text));
  const auto end = Clock::now() + std::chrono::duration<double>(endurance_seconds);
  while (Clock::now() < end) {
    if (auto message = link.Receive()) return std::move(message->text);
    std::this_thread::sleep_for(kPoll);
  }
  return std::nullopt;
}

/// After a while, or as soon as there is news.
std::string NextWord(std::optional<Run>& run) {
  if (!run) return std::string(compare::kIdle);
  if (!run->Wait(kBeat)) return std::string(compare::kBusy);
  const auto record = run->Take();
  run.reset();
  return record ? compare::ToLine(*record) : std::string(compare::kIdle);
}

}  // namespace

Ending Work(MpiLink& link, compare::RunCommand command, double endurance_seconds) {
  std::optional<Run> run;
  while (true) {
    const auto answer = Ask(link, NextWord(run), endurance_seconds);
    if (!answer) return Ending::kMasterSilent;
    if (*answer == compare::kStop) return Ending::kTogether;
    if (*answer == compare::kLeave) return Ending::kLeave;
    if (*answer == compare::kDrop) run.reset();
    if (*answer == compare::kWait) std::this_thread::sleep_for(kPause);
    if (auto task = compare::TaskFromText(*answer)) {
      command.limits = task->limits;
      run.emplace(std::move(task->run), command);
    }
  }
}

}  // namespace latchwork::mpi

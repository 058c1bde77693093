// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_DISPATCH_DISPATCHER_H_
#define LATCHWORK_APPS_COMPARE_DISPATCH_DISPATCHER_H_

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/compare/runs/run_record.h"
#include "apps/compare/runs/task.h"

namespace latchwork::compare {

/// What workers say, besides a record (see ToLine) of the run that they were given, and what they
/// are answered, besides a task (see ToText).
inline constexpr std::string_view kIdle = "idle";  ///< Gives me a run.
inline constexpr std::string_view kBusy = "busy";  ///< I am still at it.
inline constexpr std::string_view kGoOn = "go on";
inline constexpr std::string_view kWait = "wait";    ///< Ask again soon.
inline constexpr std::string_view kDrop = "drop";    ///< Nobody needs your run any more.
inline constexpr std::string_view kStop = "stop";    ///< All is done; everybody has been told.
inline constexpr std::string_view kLeave = "leave";  ///< The same, but somebody was lost.

/// Hands runs out to workers that may die. A worker speaks every now and then and is answered each
/// time; the run of one that has been silent for too long is given to another. Whichever record of
/// a run comes first counts: runs repeat, so it does not matter whose. Knows nothing of how
/// messages travel, and of time only what it is told, in seconds. Thread rule: one thread.
class Dispatcher {
 public:
  struct Options {
    int workers = 0;                 ///< Numbered from 1.
    double patience_seconds = 30;    ///< With one worker.
    double endurance_seconds = 120;  ///< With all of them: then the work is ended.
    RunLimits limits;
    /// Told of each run, once; false ends the work.
    std::function<bool(const RunRecord& record)> on_done;
    /// Told, in words, of what went wrong and is mended.
    std::function<void(const std::string& text)> on_loss;
  };

  Dispatcher(std::vector<PlannedRun> runs, Options options, double now);

  /// The answer to what a worker said.
  std::string Answer(int worker, std::string_view said, double now);

  /// Takes the runs of those who are silent. To be called often.
  void Look(double now);

  /// No run is missing, or the work was ended, and every worker knows it or is lost.
  bool finished() const;
  /// Runs that nobody made: the work was ended.
  std::size_t missing() const { return runs_.size() - done_; }
  /// Whether all workers are told to stop together, and none was lost meanwhile.
  bool together() const { return farewell_ == kStop && !lost_any(); }

 private:
  enum class Standing { kWaiting, kGiven, kDone };
  struct Entry {
    PlannedRun run;
    Standing standing = Standing::kWaiting;
  };
  struct Worker {
    std::optional<std::size_t> run;
    double heard = 0;
    bool lost = false;
    bool at_end = false;  ///< Has spoken since the end began.
    bool told = false;
  };

  void Take(Worker& worker, const RunRecord& record);
  void Release(Worker& worker);
  std::string Next(Worker& worker);
  std::string Farewell(Worker& worker);
  bool lost_any() const;
  bool is_ending() const { return ended_ || done_ == runs_.size(); }

  Options options_;
  std::vector<Entry> runs_;
  std::map<RunKey, std::size_t> places_;
  std::map<int, Worker> workers_;
  std::size_t next_ = 0;  ///< Before it, no run waits.
  std::size_t done_ = 0;
  bool ended_ = false;
  std::string_view farewell_;  ///< The same for everybody.
};

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_DISPATCH_DISPATCHER_H_

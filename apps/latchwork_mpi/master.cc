// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork_mpi/master.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <thread>
#include <utility>
#include <vector>

#include "apps/compare/dispatch/dispatcher.h"
#include "apps/latchwork/progress.h"

namespace latchwork::mpi {
namespace {

using namespace std::chrono_literals;

double Now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

compare::Dispatcher::Options Dispatching(const MpiLink& link, const MasterOptions& options) {
  compare::Dispatcher::Options dispatching;
  dispatching.workers = link.size() - 1;
  dispatching.patience_seconds = options.patience_seconds;
  dispatching.endurance_seconds = options.endurance_seconds;
  dispatching.on_loss = [](const std::string& text) { fmt::print(stderr, "{}\n", text); };
  return dispatching;
}

Shift Attend(MpiLink& link, compare::Dispatcher& dispatcher) {
  while (!dispatcher.finished()) {
    if (const auto message = link.Receive()) {
      link.Send(message->from, dispatcher.Answer(message->from, message->text, Now()));
      continue;
    }
    dispatcher.Look(Now());
    std::this_thread::sleep_for(500us);
  }
  link.Flush();
  return {dispatcher.missing(), dispatcher.together()};
}

}  // namespace

Shift Lead(MpiLink& link, const compare::Experiment& experiment, compare::ResultFolder& folder,
           const MasterOptions& options) {
  std::vector<compare::PlannedRun> runs = folder.Missing();
  if (folder.trouble().kind != compare::Trouble::Kind::kNone) runs.clear();
  const std::size_t total = runs.size();
  std::size_t done = 0;
  app::Progress progress("runs", options.quiet);
  compare::Dispatcher::Options dispatching = Dispatching(link, options);
  dispatching.limits = experiment.limits;
  dispatching.on_done = [&](const compare::RunRecord& record) {
    progress.Update(++done, total);
    return folder.Keep(record);
  };
  compare::Dispatcher dispatcher(std::move(runs), std::move(dispatching), Now());
  return Attend(link, dispatcher);
}

Shift SendAway(MpiLink& link, const MasterOptions& options) {
  compare::Dispatcher dispatcher({}, Dispatching(link, options), Now());
  return Attend(link, dispatcher);
}

}  // namespace latchwork::mpi

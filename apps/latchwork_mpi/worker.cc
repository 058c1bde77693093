// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork_mpi/worker.h"

#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "apps/compare/dispatch/dispatcher.h"
#include "apps/compare/runs/fork_server.h"

namespace latchwork::mpi {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kBeat = 1s;  ///< Between two words from a worker that is busy.
constexpr auto kPause = 50ms;
constexpr auto kPoll = 500us;

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
std::string NextWord(compare::ForkServer& server) {
  if (!server.is_busy()) return std::string(compare::kIdle);
  const auto record = server.Wait(kBeat);
  return record ? compare::ToLine(*record) : std::string(compare::kBusy);
}

}  // namespace

Ending Work(MpiLink& link, const compare::Launch& launch, double endurance_seconds) {
  compare::ForkServer server(launch);
  while (true) {
    const auto answer = Ask(link, NextWord(server), endurance_seconds);
    if (!answer) return Ending::kMasterSilent;
    if (*answer == compare::kStop) return Ending::kTogether;
    if (*answer == compare::kLeave) return Ending::kLeave;
    if (*answer == compare::kDrop) server.End();
    if (*answer == compare::kWait) std::this_thread::sleep_for(kPause);
    if (const auto task = compare::TaskFromText(*answer)) server.Begin(*task);
  }
}

}  // namespace latchwork::mpi

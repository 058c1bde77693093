// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_RUN_AGENT_H_
#define LATCHWORK_APPS_LATCHWORK_RUN_AGENT_H_

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "latchwork/config/agent.h"
#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/plugin/registry.h"
#include "latchwork/schedule/agent.h"
#include "latchwork/schedule/statistics.h"
#include "latchwork/schedule/tick_record.h"

namespace latchwork::app {

/// One run of one agent file.
struct RunRequest {
  std::filesystem::path agent_file;
  /// A fragment whose overrides and events come on top.
  std::optional<std::filesystem::path> scenario;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> ticks;
  std::vector<config::Override> overrides;
  std::filesystem::path out;  ///< Where journal, summary and pictures go; empty: nowhere.
  unsigned threads = 1;
};

/// What happened to the world from outside, and why the world could not do it (else empty).
struct EventNote {
  std::uint64_t tick = 0;
  std::string fact;
  std::string problem;
};

struct FinishedRun {
  RunRequest request;
  int exit_code = 0;
  std::string agent_name;
  double tick_s = 0;
  double duration_s = 0;  ///< How long it may last in the world.
  std::string errors;     ///< Diagnostics or I/O errors, ready to print; empty when all went well.
  schedule::RunResult result;            ///< Only when the run began.
  std::vector<schedule::Fault> faults;   ///< The first of each layer and kind, with its tick.
  std::vector<std::string> layer_names;  ///< For the faults.
  std::vector<EventNote> events;
  std::string trajectory;  ///< See Trajectory::ToText.
  std::vector<std::filesystem::path> written;
  std::vector<std::filesystem::path> libraries;  ///< Of its plugins; each may come several times.
  bool began = false;
};

/// An agent that can run, or all that is wrong with it.
struct PreparedAgent {
  std::optional<schedule::Agent> agent;
  logic::Diagnostics diagnostics;
  int exit_code = 0;
};

/// Reads, checks and assembles the agent of a request. `symbols` outlives it.
PreparedAgent PrepareAgent(const RunRequest& request, const plugin::Registry& registry,
                           logic::SymbolTable& symbols);

/// Told after every tick: ticks done and in all. The run stops when it returns false.
using TickNotice = std::function<bool(std::uint64_t done, std::uint64_t total)>;

/// Reads, checks, assembles and runs, and writes what the run leaves behind.
FinishedRun RunAgent(const RunRequest& request, const plugin::Registry& registry,
                     const TickNotice& notice);

/// The command that repeats a run.
std::string CommandOf(const RunRequest& request);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_RUN_AGENT_H_

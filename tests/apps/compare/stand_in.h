// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_APPS_COMPARE_STAND_IN_H_
#define LATCHWORK_TESTS_APPS_COMPARE_STAND_IN_H_

#include <string>

#include "apps/compare/runs/launch.h"

namespace latchwork::compare {

/// Answers the task in $task: the goal is reached, after as many seconds as the seed says, so that
/// a run's own record can be told from that of a neighbour.
inline constexpr const char* kAnswer =
    "key=${task%%,\\\"arguments*}\n"
    "printf '%s,\"outcome\":\"reached\",\"command\":\"\",\"measures\":{\"time_s\":%s},"
    "\"wall_s\":0,\"cpu_s\":0}\\n' \"$key\" \"${key##*:}\"\n";

/// In place of a fork server, a shell's: without `script`, one that answers every task.
inline Launch StandIn(const std::string& script = "") {
  const std::string answering = std::string("while read -r task; do\n") + kAnswer + "done\n";
  return {"/bin/sh", {"-c", "echo ready\n" + (script.empty() ? answering : script)}};
}

}  // namespace latchwork::compare

#endif  // LATCHWORK_TESTS_APPS_COMPARE_STAND_IN_H_

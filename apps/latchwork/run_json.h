// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_RUN_JSON_H_
#define LATCHWORK_APPS_LATCHWORK_RUN_JSON_H_

#include <string>
#include <vector>

#include "apps/latchwork/run_agent.h"

namespace latchwork::app {

/// The summary of a single run as an object, of several runs as an array of such objects, each with
/// its agent file.
std::string ToJson(const std::vector<FinishedRun>& runs);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_RUN_JSON_H_

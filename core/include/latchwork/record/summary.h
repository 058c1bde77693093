// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_SUMMARY_H_
#define LATCHWORK_RECORD_SUMMARY_H_

#include <string>

#include "latchwork/schedule/statistics.h"

namespace latchwork::record {

/// The figures of a run as a JSON object: outcome, collisions, ticks, seed, layers, and the
/// measures of the world. Wall times are here and not in the journal.
std::string SummaryJson(const schedule::RunResult& result);

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_SUMMARY_H_

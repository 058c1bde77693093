// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_REPLAY_H_
#define LATCHWORK_RECORD_REPLAY_H_

#include <cstdint>
#include <optional>
#include <string>

#include "latchwork/record/journal.h"
#include "latchwork/schedule/agent.h"

namespace latchwork::record {

/// The first thing that came out otherwise.
struct Divergence {
  std::uint64_t tick = 0;
  std::string place;  ///< "layer avoid, conclusions[0]", "sensor sonar[3]", "commands drive[0]", …
  std::string recorded;  ///< "(nothing)" for what the journal does not have.
  std::string now;
};

/// "tick 17, layer avoid, conclusions[0]: turn(0.21) in the journal, turn(0.25) now"
std::string ToString(const Divergence& divergence);

struct ReplayResult {
  std::uint64_t ticks = 0;  ///< That agreed.
  std::optional<Divergence> divergence;
};

/// Runs the agent again and compares it with the journal tick by tick; stops at the first
/// difference, or where the journal ends. `agent` is assembled anew, with the seed, the overrides
/// and the scenario of the journal's header. Compare the headers first (Differences).
ReplayResult Replay(const Journal& journal, schedule::Agent agent, unsigned threads = 1);

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_REPLAY_H_

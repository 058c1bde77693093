// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_REPLAY_H_
#define LATCHWORK_RECORD_REPLAY_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "latchwork/record/journal_reader.h"
#include "latchwork/schedule/agent.h"
#include "latchwork/schedule/tick_record.h"

namespace latchwork::record {

/// The first thing that came out otherwise.
struct Divergence {
  std::uint64_t tick = 0;
  std::string place;  ///< "layer avoid, conclusion 1", "sensor sonar, fact 3", "command drive, …"
  std::string recorded;  ///< "nothing" for what the journal does not have.
  std::string now;
};

/// "tick 17, layer avoid, conclusion 1: journal turn(0.21), now turn(0.25)"
std::string ToString(const Divergence& divergence);

/// Compares a run with a journal, tick by tick. Ends the run at the first difference, and where
/// the journal stops before its run did. Thread rule: one thread.
class ReplayObserver : public schedule::RunObserver {
 public:
  /// The journal outlives the observer; nothing but its header has been read. Of the agent only
  /// names are used, and only here. `notice` is told after every tick how many agree.
  ReplayObserver(JournalReader& journal, const schedule::Agent& agent,
                 std::function<void(std::uint64_t ticks)> notice = {});
  ~ReplayObserver() override;
  ReplayObserver(const ReplayObserver&) = delete;
  ReplayObserver& operator=(const ReplayObserver&) = delete;

  bool OnTick(const schedule::TickRecord& record) override;
  void OnEnd(const schedule::RunResult& result) override;

  std::uint64_t ticks() const;  ///< That agree.
  const std::optional<Divergence>& divergence() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

struct ReplayResult {
  std::uint64_t ticks = 0;  ///< That agree.
  std::optional<Divergence> divergence;
};

/// Runs the agent and compares it with the journal, whose header must be there. `agent` is
/// assembled anew, with the seed, the overrides and the scenario of the header. Compare the headers
/// first (Differences), and ask the reader for its problem afterwards. `notice` is told after every
/// tick how many agree.
ReplayResult Replay(JournalReader& journal, schedule::Agent agent, unsigned threads = 1,
                    const std::function<void(std::uint64_t ticks)>& notice = {});

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_REPLAY_H_

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/record/replay.h"

#include <fmt/format.h>

#include <utility>

#include "core/record/json_difference.h"
#include "core/record/tick_encoder.h"
#include "latchwork/schedule/lockstep.h"

namespace latchwork::record {
namespace {

/// Compares a run with a journal while it runs.
class Comparison : public schedule::RunObserver {
 public:
  Comparison(const Journal& journal, const schedule::Agent& agent)
      : journal_(journal), encoder_(agent) {}

  bool OnTick(const schedule::TickRecord& record) override {
    if (result_.ticks == journal_.ticks.size()) {
      Diverge(record.tick, {"run", "over", "goes on"});
      return false;
    }
    const std::string& recorded = journal_.ticks[result_.ticks].json;
    if (const auto difference = FindDifference(recorded, encoder_.Encode(record))) {
      Diverge(record.tick, *difference);
      return false;
    }
    ++result_.ticks;
    // Of a journal without its end nobody knows how the run went on.
    return result_.ticks < journal_.ticks.size() || !journal_.end.empty();
  }

  void OnEnd(const schedule::RunResult& run) override {
    if (result_.divergence) return;
    if (result_.ticks < journal_.ticks.size()) {
      Diverge(result_.ticks, {"run", "goes on", "over: " + run.message});
    } else if (!journal_.end.empty()) {
      const std::string now = TickEncoder::EncodeEnd(run);
      if (const auto difference = FindDifference(journal_.end, now)) {
        Diverge(result_.ticks, *difference);
      }
    }
  }

  ReplayResult& result() { return result_; }

 private:
  void Diverge(std::uint64_t tick, const FrameDifference& difference) {
    result_.divergence = {tick, difference.place, difference.recorded, difference.now};
  }

  const Journal& journal_;
  TickEncoder encoder_;
  ReplayResult result_;
};

}  // namespace

std::string ToString(const Divergence& divergence) {
  return fmt::format("tick {}, {}: {} in the journal, {} now", divergence.tick, divergence.place,
                     divergence.recorded, divergence.now);
}

ReplayResult Replay(const Journal& journal, schedule::Agent agent, unsigned threads) {
  Comparison comparison(journal, agent);
  const bool nothing_to_compare = journal.ticks.empty() && journal.end.empty();
  schedule::LockstepOptions options;
  options.threads = threads;
  options.max_ticks = nothing_to_compare ? 0 : journal.header.max_ticks;
  options.observers.push_back(&comparison);
  schedule::Lockstep(std::move(agent), std::move(options)).Run();
  return std::move(comparison.result());
}

}  // namespace latchwork::record

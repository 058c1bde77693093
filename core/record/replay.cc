// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/record/replay.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "core/record/frame_rows.h"
#include "core/record/tick_encoder.h"
#include "latchwork/schedule/lockstep.h"

namespace latchwork::record {

using Notice = std::function<void(std::uint64_t ticks)>;

namespace {

/// Whether the recorded run ended here because an observer said so, a person perhaps.
bool WasStopped(const JournalFrame& frame) {
  static const std::string kStopped =
      fmt::format(R"({{"end":{{"outcome":"{}")", Name(schedule::RunResult::State::kStopped));
  return frame.kind == JournalFrame::Kind::kEnd && frame.json.starts_with(kStopped);
}

}  // namespace

/// Reads one frame ahead, to end the run in time.
class ReplayObserver::Implementation {
 public:
  Implementation(JournalReader& journal, const schedule::Agent& agent, Notice notice)
      : journal_(journal), encoder_(agent), notice_(std::move(notice)), next_(journal.Next()) {}

  bool Tick(const schedule::TickRecord& record) {
    if (!next_) return false;
    if (next_->kind == JournalFrame::Kind::kEnd) {
      return Diverge({"run", "over", "goes on"});
    }
    if (const auto difference = FindDifference(next_->json, encoder_.Encode(record))) {
      return Diverge(*difference);
    }
    ++ticks_;
    if (notice_) notice_(ticks_);
    next_ = journal_.Next();
    return next_.has_value() && !WasStopped(*next_);
  }

  void End(const schedule::RunResult& result) {
    if (divergence_ || !next_) return;
    if (next_->kind == JournalFrame::Kind::kTick) {
      Diverge({"run", "goes on", fmt::format("{}: {}", Name(result.state), result.message)});
    } else if (const auto difference = FindDifference(next_->json, encoder_.EncodeEnd(result))) {
      Diverge(*difference);
    }
  }

  std::uint64_t ticks() const { return ticks_; }
  const std::optional<Divergence>& divergence() const { return divergence_; }

 private:
  bool Diverge(const FrameDifference& difference) {
    divergence_ = {ticks_, difference.place, difference.recorded, difference.now};
    return false;
  }

  JournalReader& journal_;
  TickEncoder encoder_;
  Notice notice_;
  std::optional<JournalFrame> next_;
  std::uint64_t ticks_ = 0;
  std::optional<Divergence> divergence_;
};

ReplayObserver::ReplayObserver(JournalReader& journal, const schedule::Agent& agent, Notice notice)
    : implementation_(std::make_unique<Implementation>(journal, agent, std::move(notice))) {}
ReplayObserver::~ReplayObserver() = default;

bool ReplayObserver::OnTick(const schedule::TickRecord& record) {
  return implementation_->Tick(record);
}
void ReplayObserver::OnEnd(const schedule::RunResult& result) { implementation_->End(result); }
std::uint64_t ReplayObserver::ticks() const { return implementation_->ticks(); }
const std::optional<Divergence>& ReplayObserver::divergence() const {
  return implementation_->divergence();
}

std::string ToString(const Divergence& divergence) {
  return fmt::format("tick {}, {}: journal {}, now {}", divergence.tick, divergence.place,
                     divergence.recorded, divergence.now);
}

ReplayResult Replay(JournalReader& journal, schedule::Agent agent, unsigned threads,
                    const Notice& notice) {
  ReplayObserver observer(journal, agent, notice);
  schedule::LockstepOptions options;
  options.threads = threads;
  options.max_ticks = journal.header()->max_ticks;
  options.observers.push_back(&observer);
  schedule::Lockstep(std::move(agent), std::move(options)).Run();
  return {observer.ticks(), observer.divergence()};
}

}  // namespace latchwork::record

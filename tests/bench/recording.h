// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_BENCH_RECORDING_H_
#define LATCHWORK_TESTS_BENCH_RECORDING_H_

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/schedule/lockstep.h"
#include "tests/bench/office_agent.h"

namespace latchwork {

inline constexpr std::uint64_t kRecordedTicks = 1500;

/// What a layer's reasoner was asked, in order.
struct Event {
  std::vector<sdk::Latch> latches;
  sdk::Budget budget;
  bool admission = false;
  std::size_t port = 0;
  std::vector<logic::Fact> batch;
};

class Recorder final : public sdk::Reasoner {
 public:
  explicit Recorder(std::shared_ptr<sdk::Reasoner> inner) : inner_(std::move(inner)) {}

  std::string_view language() const override { return inner_->language(); }
  std::span<const sdk::ParameterSpec> parameters() const override { return inner_->parameters(); }
  logic::Diagnostics Load(const sdk::Body& body, const sdk::Parameters& parameters,
                          logic::SymbolTable& symbols) override {
    return inner_->Load(body, parameters, symbols);
  }
  void Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
              sdk::Decision& decision) override {
    Note(latches, budget);
    inner_->Decide(latches, budget, decision);
  }
  void Admit(std::span<const sdk::Latch> latches, std::size_t port,
             std::span<const logic::Fact> batch, const sdk::Budget& budget,
             std::vector<sdk::Refusal>& refused) override {
    Note(latches, budget);
    events.back().admission = true;
    events.back().port = port;
    events.back().batch.assign(batch.begin(), batch.end());
    inner_->Admit(latches, port, batch, budget, refused);
  }
  logic::Diagnostics Tell(std::string_view text) override { return inner_->Tell(text); }
  logic::Diagnostics Retract(std::string_view name) override { return inner_->Retract(name); }
  sdk::Derivation Explain(std::size_t conclusion) override { return inner_->Explain(conclusion); }

  std::vector<Event> events;

 private:
  void Note(std::span<const sdk::Latch> latches, const sdk::Budget& budget) {
    events.push_back({{latches.begin(), latches.end()}, budget, false, 0, {}});
    events.back().budget.cancelled = nullptr;
  }

  std::shared_ptr<sdk::Reasoner> inner_;
};

/// The latches of a run of scenario 3, another floor.
struct Recording {
  logic::SymbolTable symbols;
  plugin::Registry registry = MakeRegistry();
  std::vector<std::vector<Event>> layers;
};

/// Made once: a run takes longer than all decisions in it.
inline Recording& TheRecording() {
  static Recording recording;
  if (!recording.layers.empty()) return recording;
  auto agent = MakeAgent("scenario3.xml", recording.registry, recording.symbols, 1);
  if (!agent) return recording;
  std::vector<std::shared_ptr<Recorder>> recorders;
  for (auto& layer : agent->layers) {
    recorders.push_back(std::make_shared<Recorder>(layer.reasoner));
    layer.reasoner = recorders.back();
  }
  schedule::LockstepOptions options;
  options.max_ticks = kRecordedTicks;
  schedule::Lockstep(std::move(*agent), options).Run();
  for (const auto& recorder : recorders) recording.layers.push_back(std::move(recorder->events));
  return recording;
}

}  // namespace latchwork

#endif  // LATCHWORK_TESTS_BENCH_RECORDING_H_

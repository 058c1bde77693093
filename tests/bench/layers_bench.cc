// SPDX-License-Identifier: BSD-3-Clause
//
// What the four layers of the office agent decide in scenario 3, another floor: the latches of a
// run are recorded, then every layer goes through its cycles again, timed one by one.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/schedule/lockstep.h"
#include "tests/bench/cpu_clock.h"
#include "tests/bench/office_agent.h"

namespace latchwork {
namespace {

constexpr std::uint64_t kTicks = 1500;

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

struct Recording {
  logic::SymbolTable symbols;
  plugin::Registry registry = MakeRegistry();
  std::vector<std::vector<Event>> layers;
};

/// Made once: a run takes longer than all decisions in it.
Recording& TheRecording() {
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
  options.max_ticks = kTicks;
  schedule::Lockstep(std::move(*agent), options).Run();
  for (const auto& recorder : recorders) recording.layers.push_back(std::move(recorder->events));
  return recording;
}

void LayerDecides(benchmark::State& state) {
  Recording& recording = TheRecording();
  auto agent = MakeAgent("scenario3.xml", recording.registry, recording.symbols, 1);
  if (!agent) return state.SkipWithError("cannot assemble scenario3.xml");
  const auto layer = static_cast<std::size_t>(state.range(0));
  sdk::Reasoner& reasoner = *agent->layers[layer].reasoner;
  state.SetLabel(agent->description.layers[layer].name);
  Sample micros;
  Sample admission_micros;
  Sample inferences;
  sdk::Decision decision;
  std::vector<sdk::Refusal> refused;
  for (auto _ : state) {
    for (const Event& event : recording.layers[layer]) {
      refused.clear();
      const double start = ThreadSeconds();
      if (event.admission) {
        reasoner.Admit(event.latches, event.port, event.batch, event.budget, refused);
      } else {
        reasoner.Decide(event.latches, event.budget, decision);
      }
      const double taken = (ThreadSeconds() - start) * 1e6;
      (event.admission ? admission_micros : micros).Add(taken);
      if (!event.admission) inferences.Add(static_cast<double>(decision.statistics.inferences));
    }
  }
  micros.Report("us", state);
  if (!admission_micros.empty()) admission_micros.Report("admit_us", state);
  inferences.Report("inf", state);
}
BENCHMARK(LayerDecides)->DenseRange(0, 3)->ArgName("layer")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latchwork

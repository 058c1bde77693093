// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_CORE_SCHEDULE_FAKES_H_
#define LATCHWORK_TESTS_CORE_SCHEDULE_FAKES_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/schedule/agent.h"
#include "latchwork/schedule/lockstep.h"

namespace latchwork::schedule::testing {

/// Ports by shape: {"sonar", {{"echo", 2}}} declares echo/2 with arguments of any type.
sdk::PortSpec Port(std::string name,
                   std::vector<std::pair<std::string, std::vector<sdk::ArgumentType>>> predicates);

class FakeWorld : public sdk::World {
 public:
  sdk::Contract shape;
  std::function<void(std::uint64_t tick, std::span<sdk::Batch> sensors)> observe;
  std::function<void(std::uint64_t tick)> step;
  std::function<sdk::Outcome()> say_outcome;
  logic::Diagnostics load_diagnostics;
  std::vector<std::vector<std::vector<std::string>>> told;  ///< [tick][effector][fact]
  std::vector<std::vector<bool>> updated;                   ///< [tick][effector]
  std::vector<std::string> calls;

  const sdk::Contract& contract() const override { return shape; }
  std::span<const sdk::ParameterSpec> parameters() const override { return {}; }
  std::span<const sdk::PredicateSpec> events() const override { return {}; }
  logic::Diagnostics Load(const sdk::WorldSetup& setup, const sdk::Parameters&) override;
  void Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) override;
  void Apply(std::uint64_t tick, std::span<const sdk::Batch> effectors) override;
  void Step(std::uint64_t tick) override;
  logic::Diagnostics HandleEvent(std::uint64_t tick, const logic::Fact& event) override;
  sdk::Outcome outcome() const override;
  std::vector<std::pair<std::string, double>> Measures() const override {
    return {{"collisions", 0}};
  }
  std::vector<std::filesystem::path> Draw(const std::filesystem::path&) const override {
    return {};
  }

  sdk::WorldSetup setup;
};

class FakeLayer : public sdk::Layer {
 public:
  sdk::Contract shape;
  std::vector<sdk::Fallback> fallback;

  const sdk::Contract& contract() const override { return shape; }
  std::span<const sdk::ParameterSpec> parameters() const override { return {}; }
  std::vector<std::string> languages() const override { return {"fake"}; }
  /// One goal for each predicate of each output port.
  sdk::Body MakeBody(std::string_view, const sdk::Parameters&, const std::filesystem::path&,
                     logic::SymbolTable& symbols) const override;
  std::vector<sdk::Fallback> fallbacks(logic::SymbolTable&) const override { return fallback; }
};

class FakeReasoner : public sdk::Reasoner {
 public:
  using Decider =
      std::function<void(std::span<const sdk::Latch>, const sdk::Budget&, sdk::Decision&)>;
  using Admitter = std::function<void(std::span<const sdk::Latch>, std::size_t port,
                                      std::span<const logic::Fact>, std::vector<sdk::Refusal>&)>;
  Decider decide;
  Admitter admit;
  logic::Diagnostics load_diagnostics;
  sdk::Body body;
  std::size_t admit_calls = 0;
  std::size_t decide_calls = 0;
  bool takes = false;      ///< Undecided latch facts.
  bool remembers = false;  ///< Its decisions depend on earlier ones.

  std::string_view language() const override { return "fake"; }
  bool takes_undecided() const override { return takes; }
  bool keeps_memory() const override { return remembers; }
  std::span<const sdk::ParameterSpec> parameters() const override { return {}; }
  logic::Diagnostics Load(const sdk::Body& given, const sdk::Parameters&,
                          logic::SymbolTable&) override;
  void Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
              sdk::Decision& decision) override;
  void Admit(std::span<const sdk::Latch> latches, std::size_t port,
             std::span<const logic::Fact> batch, const sdk::Budget&,
             std::vector<sdk::Refusal>& refused) override;
  logic::Diagnostics Tell(std::string_view) override { return {}; }
  logic::Diagnostics Retract(std::string_view) override { return {}; }
  sdk::Derivation Explain(std::size_t) override { return {}; }
};

/// An agent of fakes. Layer i is made by plugin "layer<i>" and reasoner "reasoner<i>".
class FakeAgent {
 public:
  FakeAgent();

  std::size_t AddLayer(std::vector<sdk::PortSpec> inputs, std::vector<sdk::PortSpec> outputs);
  void Wire(config::PortAddress from, config::PortAddress to,
            std::optional<std::uint64_t> stale_after = std::nullopt,
            config::Transfer transfer = config::Transfer::kOpen);

  config::LayerDescription& description(std::size_t layer) { return agent.layers[layer]; }
  FakeLayer& layer(std::size_t index) { return *layers[index]; }
  FakeReasoner& reasoner(std::size_t index) { return *reasoners[index]; }

  logic::Fact Fact(std::string_view predicate, std::initializer_list<logic::Term> terms = {});
  logic::Term Name(std::string_view name);
  /// Adds a conclusion of the goal with this predicate.
  void Conclude(sdk::Decision& decision, std::size_t goal, logic::Fact fact);

  PartFactory Factory() const;
  AssembledAgent Assemble(std::uint64_t seed = 1);
  /// Aborts the test when the agent cannot be assembled.
  std::unique_ptr<Lockstep> Start(LockstepOptions options = {}, std::uint64_t seed = 1);

  logic::SymbolTable symbols;
  config::AgentDescription agent;
  std::shared_ptr<FakeWorld> world;
  std::vector<std::shared_ptr<FakeLayer>> layers;
  std::vector<std::shared_ptr<FakeReasoner>> reasoners;
};

inline constexpr std::size_t kWorld = config::PortAddress::kWorld;

/// Keeps what a run shows as text.
class Recorder : public RunObserver {
 public:
  bool OnTick(const TickRecord& record) override;
  void OnEnd(const RunResult& result) override { ended = result.ticks; }

  std::vector<std::string> latched;  ///< "tick layer.port@version[!]: facts"
  std::vector<std::string> refused;  ///< "tick part.port fact: reason"
  std::vector<std::string> decided;  ///< "tick layer status[!]: facts said"
  std::vector<std::string> inhibited;
  std::vector<std::string> events;
  std::vector<Fault> faults;
  std::optional<std::uint64_t> stop_at;
  std::optional<std::uint64_t> ended;
};

std::string Join(std::span<const logic::Fact> facts);

}  // namespace latchwork::schedule::testing

#endif  // LATCHWORK_TESTS_CORE_SCHEDULE_FAKES_H_

// SPDX-License-Identifier: BSD-3-Clause
//
// Subsumption as it can be seen from outside: the real layers `avoid` and `seek` on the real
// prover, in a world that says what the test wants to be sensed, below a scripted layer that makes
// claims.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/config/agent.h"
#include "latchwork/plugin/registry.h"
#include "latchwork/schedule/agent.h"
#include "latchwork/schedule/lockstep.h"
#include "tests/core/schedule/fakes.h"
#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using test::TemporaryFolder;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

using schedule::testing::FakeLayer;
using schedule::testing::FakeReasoner;
using schedule::testing::FakeWorld;
using schedule::testing::Port;
using schedule::testing::Recorder;
using sdk::ArgumentType;

constexpr std::string_view kSeekOverAvoid = R"(<?xml version="1.0"?>
<agent format="1" name="two-layers" tick="100ms" duration="60s">
  <world plugin="scripted"/>
  <layer name="avoid" plugin="avoid" period="100ms">
    <reasoner plugin="pttp" inferences="100000" depth="24"/>
  </layer>
  <layer name="seek" plugin="seek" period="100ms">
    <reasoner plugin="pttp" inferences="100000" depth="24"/>
  </layer>
  <wire from="world.sonar" to="avoid.sonar" stale-after="300ms"/>
  <wire from="world.robot" to="avoid.robot"/>
  <wire from="seek.push" to="avoid.objects" stale-after="500ms"/>
  <wire from="avoid.motion" to="world.drive"/>
  <wire from="world.pose" to="seek.pose" stale-after="300ms"/>
  <wire from="world.destination" to="seek.destination" stale-after="300ms"/>
  <layer name="claims" plugin="claims" period="100ms">
    <reasoner plugin="claims" inferences="1000" depth="10"/>
  </layer>
  <inhibit by="claims.push" output="seek.push"/>
</agent>
)";

constexpr std::string_view kClaimsOverAvoid = R"(<?xml version="1.0"?>
<agent format="1" name="claims" tick="100ms" duration="60s">
  <world plugin="scripted"/>
  <layer name="avoid" plugin="avoid" period="100ms">
    <reasoner plugin="pttp" inferences="100000" depth="24"/>
  </layer>
  <layer name="claims" plugin="claims" period="100ms">
    <reasoner plugin="claims" inferences="1000" depth="10"/>
  </layer>
  <wire from="world.sonar" to="avoid.sonar" stale-after="300ms"/>
  <wire from="world.robot" to="avoid.robot"/>
  <wire from="claims.push" to="avoid.objects" stale-after="300ms"/>
  <wire from="avoid.motion" to="world.drive"/>
</agent>
)";

/// The robot stands at the origin, looks east and hears what `gaps` says (no entry: no echo).
class SubsumptionTest : public ::testing::Test {
 protected:
  SubsumptionTest()
      : registry_({std::filesystem::path(LATCHWORK_BINARY_DIR) / "plugins"}),
        world_(std::make_shared<FakeWorld>()),
        claims_layer_(std::make_shared<FakeLayer>()),
        claims_(std::make_shared<FakeReasoner>()) {
    world_->shape.outputs = {
        Port("sonar", {{"sonar_reading", {ArgumentType::kInteger, ArgumentType::kReal}},
                       {"no_echo", {ArgumentType::kInteger}}}),
        Port("robot", {{"sonar_direction", {ArgumentType::kInteger, ArgumentType::kReal}},
                       {"robot_radius", {ArgumentType::kReal}}}),
        Port("pose", {{"curr_location", {ArgumentType::kReal, ArgumentType::kReal}},
                      {"curr_heading", {ArgumentType::kReal}}}),
        Port("destination", {{"move_cmd", {ArgumentType::kReal, ArgumentType::kReal}}})};
    world_->shape.inputs = {Port(
        "drive", {{"fwd", {ArgumentType::kReal}}, {"turn", {ArgumentType::kReal}}, {"halt", {}}})};
    world_->observe = [this](std::uint64_t tick, std::span<sdk::Batch> sensors) {
      Observe(tick, sensors);
    };
    claims_layer_->shape.outputs = {
        Port("push", {{"object", {ArgumentType::kAny}},
                      {"distance", {ArgumentType::kAny, ArgumentType::kReal}},
                      {"direction", {ArgumentType::kAny, ArgumentType::kReal}}})};
  }

  logic::Fact Fact(std::string_view predicate, std::initializer_list<logic::Term> terms = {}) {
    return {symbols_.Intern(predicate), terms};
  }
  logic::Term Name(std::string_view name) { return logic::Term::Constant(symbols_.Intern(name)); }

  void Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) {
    for (sdk::Batch& batch : sensors) batch.updated = false;
    Say(sensors[0], SonarFacts());
    if (tick == 0) Say(sensors[1], RobotFacts());
    Say(sensors[2], {Fact("curr_location", {logic::Term::Real(0), logic::Term::Real(0)}),
                     Fact("curr_heading", {logic::Term::Real(0)})});
    Say(sensors[3], {Fact("move_cmd", {logic::Term::Real(5), logic::Term::Real(0)})});
  }

  static void Say(sdk::Batch& batch, std::vector<logic::Fact> facts) {
    batch.updated = true;
    batch.facts = std::move(facts);
  }

  std::vector<logic::Fact> SonarFacts() {
    std::vector<logic::Fact> facts;
    for (int sonar = 0; sonar < kSonars; ++sonar) {
      const auto gap = std::find_if(gaps_.begin(), gaps_.end(),
                                    [&](const auto& entry) { return entry.first == sonar; });
      facts.push_back(gap == gaps_.end() ? Fact("no_echo", {logic::Term::Integer(sonar)})
                                         : Fact("sonar_reading", {logic::Term::Integer(sonar),
                                                                  logic::Term::Real(gap->second)}));
    }
    return facts;
  }

  std::vector<logic::Fact> RobotFacts() {
    std::vector<logic::Fact> facts = {Fact("robot_radius", {logic::Term::Real(0.25)})};
    for (int sonar = 0; sonar < kSonars; ++sonar) {
      const double direction =
          std::remainder(2 * std::numbers::pi * sonar / kSonars, 2 * std::numbers::pi);
      facts.push_back(
          Fact("sonar_direction", {logic::Term::Integer(sonar), logic::Term::Real(direction)}));
    }
    return facts;
  }

  /// The claims of the layer above, as a batch of one output port with three predicates.
  void Claim(sdk::Decision& decision, std::string_view object, double distance, double direction) {
    decision.status = sdk::Status::kProved;
    decision.conclusions.push_back({0, Fact("object", {Name(object)}), {}});
    decision.conclusions.push_back(
        {1, Fact("distance", {Name(object), logic::Term::Real(distance)}), {}});
    decision.conclusions.push_back(
        {2, Fact("direction", {Name(object), logic::Term::Real(direction)}), {}});
  }

  /// The layer above claims something in these cycles, and nothing in others.
  void ClaimDuring(std::size_t from, std::size_t to) {
    claims_->decide = [this, from, to](std::span<const sdk::Latch>, const sdk::Budget&,
                                       sdk::Decision& decision) {
      const std::size_t cycle = claims_->decide_calls - 1;
      if (cycle >= from && cycle < to) Claim(decision, "glass_door", 0.3, 0.0);
    };
  }

  /// Runs an agent file for so many ticks; what was seen is in `recorder_` and `world_->told`.
  schedule::RunResult Run(std::string_view xml, std::uint64_t ticks) {
    const TemporaryFolder folder;
    WriteText(folder.path() / "agent.xml", std::string(xml));
    config::AgentFile file =
        config::ReadAgentFile(folder.path() / "agent.xml", Catalog(), {}, symbols_);
    EXPECT_EQ(logic::Format(file.diagnostics), "");
    if (!file.agent) return {};
    schedule::AssembledAgent assembled =
        AssembleAgent(std::move(*file.agent), Factory(), symbols_, 1);
    EXPECT_EQ(logic::Format(assembled.diagnostics), "");
    if (!assembled.agent) return {};
    schedule::LockstepOptions options;
    options.max_ticks = ticks;
    options.observers = {&recorder_};
    return schedule::Lockstep(std::move(*assembled.agent), options).Run();
  }

  config::Catalog Catalog() {
    config::Catalog catalog = schedule::MakeCatalog(registry_);
    const auto find = catalog.find;
    catalog.find = [this, find](sdk::PluginKind kind, std::string_view name,
                                std::string& error) -> std::optional<config::PluginFacts> {
      if (name == "scripted") return config::PluginFacts{world_->shape, {}, {}, {}};
      if (name == "claims" && kind == sdk::PluginKind::kLayer) {
        return config::PluginFacts{claims_layer_->shape, {}, {"fake"}, {}};
      }
      if (name == "claims") return config::PluginFacts{{}, {}, {"fake"}, {}};
      return find(kind, name, error);
    };
    return catalog;
  }

  schedule::PartFactory Factory() {
    schedule::PartFactory factory = schedule::MakePartFactory(registry_);
    factory.world = [this](std::string_view) { return plugin::Made<sdk::World>{world_, {}, {}}; };
    const auto layer = factory.layer;
    factory.layer = [this, layer](std::string_view name) {
      return name == "claims" ? plugin::Made<sdk::Layer>{claims_layer_, {}, {}} : layer(name);
    };
    const auto reasoner = factory.reasoner;
    factory.reasoner = [this, reasoner](std::string_view name) {
      return name == "claims" ? plugin::Made<sdk::Reasoner>{claims_, {}, {}} : reasoner(name);
    };
    return factory;
  }

  const std::vector<std::string>& Drive(std::size_t tick) const {
    return world_->told.at(tick).at(0);
  }

  static constexpr int kSonars = 16;
  plugin::Registry registry_;
  logic::SymbolTable symbols_;
  std::shared_ptr<FakeWorld> world_;
  std::shared_ptr<FakeLayer> claims_layer_;
  std::shared_ptr<FakeReasoner> claims_;
  Recorder recorder_;
  std::vector<std::pair<int, double>> gaps_;
};

TEST_F(SubsumptionTest, SeekDrivesTheRobotThroughAvoid) {
  Run(kSeekOverAvoid, 10);
  EXPECT_THAT(Drive(9), Contains(StartsWith("fwd(")));
}

TEST_F(SubsumptionTest, SilentSeekLeavesPureAvoidanceWithinStaleAfterAndComesBack) {
  ClaimDuring(20, 40);
  Run(kSeekOverAvoid, 60);
  EXPECT_THAT(Drive(19), Contains(StartsWith("fwd("))) << "pushed";
  for (std::size_t tick = 20 + 5 + 1; tick < 40; ++tick) {
    EXPECT_THAT(Drive(tick), IsEmpty()) << "nothing near, nobody pushes: tick " << tick;
  }
  EXPECT_THAT(Drive(45), Contains(StartsWith("fwd("))) << "pushed again";
}

TEST_F(SubsumptionTest, SilentSeekLeavesAvoidanceOfWhatIsNear) {
  gaps_ = {{8, 0.3}};  // Behind.
  ClaimDuring(0, 100);
  Run(kSeekOverAvoid, 20);
  EXPECT_THAT(Drive(19), Contains(StartsWith("fwd("))) << "away from what is behind";
}

TEST_F(SubsumptionTest, DefaultIsRetractedByAHigherLayerAndRestored) {
  gaps_ = {{8, 0.3}};
  ClaimDuring(10, 20);
  const schedule::RunResult result = Run(kClaimsOverAvoid, 30);
  EXPECT_THAT(Drive(8), Contains(StartsWith("fwd("))) << "rests on 'not halt_robot'";
  EXPECT_THAT(Drive(15), Contains("halt")) << "retracted: something is ahead, says the layer above";
  EXPECT_THAT(Drive(15), Not(Contains(StartsWith("fwd("))));
  EXPECT_THAT(Drive(28), Contains(StartsWith("fwd("))) << "restored";
  ASSERT_FALSE(result.layers.empty());
  EXPECT_EQ(result.layers[0].retracted, 1U);
}

TEST_F(SubsumptionTest, WhatContradictsHardFactsIsRefusedFactByFact) {
  claims_->decide = [this](std::span<const sdk::Latch>, const sdk::Budget&,
                           sdk::Decision& decision) {
    Claim(decision, "honest", 1.0, 3.0);
    Claim(decision, "liar", -2.0, 0.5);
  };
  const schedule::RunResult result = Run(kClaimsOverAvoid, 5);
  EXPECT_THAT(recorder_.refused, Contains(HasSubstr("distance(liar,")));
  EXPECT_THAT(recorder_.refused, Each(Not(HasSubstr("honest"))));
  EXPECT_THAT(recorder_.latched, Contains(HasSubstr("object(honest)")));
  EXPECT_THAT(recorder_.latched, Each(Not(HasSubstr("-2.0"))));
  EXPECT_THAT(recorder_.faults, IsEmpty());
  EXPECT_GE(result.layers[0].refused, 1U);
}

TEST_F(SubsumptionTest, HaltIsNotOverridableFromAbove) {
  gaps_ = {{0, 0.05}};  // Dead ahead, at the hull.
  claims_->decide = [this](std::span<const sdk::Latch>, const sdk::Budget&,
                           sdk::Decision& decision) { Claim(decision, "pusher", 0.3, 3.1); };
  Run(kClaimsOverAvoid, 10);
  for (std::size_t tick = 1; tick < 10; ++tick) {
    EXPECT_THAT(Drive(tick), Contains("halt"));
    EXPECT_THAT(Drive(tick), Each(Not(StartsWith("fwd("))));
  }
}

}  // namespace
}  // namespace latchwork::testing

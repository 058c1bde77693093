// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_WORLDS_CLEANING_CLEANING_FIXTURE_H_
#define LATCHWORK_TESTS_WORLDS_CLEANING_CLEANING_FIXTURE_H_

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/temporary_folder.h"
#include "worlds/cleaning/cleaning_contract.h"
#include "worlds/cleaning/cleaning_world.h"

namespace latchwork::cleaning {

/// A room of 3 m x 2 m with the dock in its west.
inline constexpr std::string_view kRoom =
    "##############\n"
    "#............#\n"
    "#............#\n"
    "#............#\n"
    "#.D..........#\n"
    "#............#\n"
    "#............#\n"
    "#............#\n"
    "#............#\n"
    "##############\n";

/// A world that is told what to do by hand, without noise and boxes unless asked for.
class CleaningFixture : public testing::Test {
 protected:
  using Values = std::vector<std::pair<std::string, std::string>>;

  logic::Diagnostics Load(const Values& values = {}, std::string_view plan = kRoom,
                          std::uint64_t seed = 1) {
    std::vector<sdk::Parameters::Given> given;
    const auto file = folder_.Write("plan.txt", plan);
    given.push_back({"plan", file.string(), {"agent.xml", 3, 5}});
    for (const auto* name : {"boxes", "overlooked", "pose_noise", "heading_noise", "range_noise"}) {
      given.push_back({name, "0", {"agent.xml", 4, 5}});
    }
    for (const auto& [name, value] : values) given.push_back({name, value, {"agent.xml", 5, 5}});
    logic::Diagnostics diagnostics;
    const auto parameters = sdk::Parameters::Check(world_.parameters(), given, "cleaning",
                                                   {"agent.xml", 2, 1}, diagnostics);
    if (!diagnostics.empty()) return diagnostics;
    return world_.Load({seed, 0.1, LATCHWORK_SOURCE_DIR "/worlds/cleaning", &symbols_}, parameters);
  }

  void Tick(double speed, double turn_rate) {
    std::vector<sdk::Batch> effectors(kEffectorPorts);
    effectors[kDrive] = {true, {Make("drive", {Number(speed), Number(turn_rate)})}};
    world_.Observe(tick_, sensors_);
    world_.Apply(tick_, effectors);
    world_.Step(tick_++);
  }
  void Ticks(int count, double speed, double turn_rate) {
    for (int i = 0; i < count; ++i) Tick(speed, turn_rate);
  }
  /// Turns on the spot until it looks into a direction.
  void Face(double heading) {
    for (int i = 0; i < 200; ++i) {
      const double left = WrapAngle(heading - world_.state().base.pose().heading);
      if (std::abs(left) < 0.005 && world_.state().base.turn_rate() == 0.0) return;
      Tick(0, std::abs(left) < 0.005 ? 0.0 : 4 * left);
    }
  }

  std::string Sensed(SensorPort port) {
    world_.Observe(tick_, sensors_);
    std::string text;
    for (const auto& fact : sensors_[port].facts) text += logic::ToString(fact) + " ";
    return text;
  }
  logic::Fact Make(const char* name, std::initializer_list<logic::Term> terms) {
    return {symbols_.Intern(name), terms};
  }
  static logic::Term Number(double value) { return logic::Term::Real(value); }
  double Measure(std::string_view name) const {
    for (const auto& [measure, value] : world_.Measures()) {
      if (measure == name) return value;
    }
    ADD_FAILURE() << "no measure " << name;
    return 0;
  }

  test::TemporaryFolder folder_;
  logic::SymbolTable symbols_;
  CleaningWorld world_;
  std::vector<sdk::Batch> sensors_ = std::vector<sdk::Batch>(kSensorPorts);
  std::uint64_t tick_ = 0;
};

}  // namespace latchwork::cleaning

#endif  // LATCHWORK_TESTS_WORLDS_CLEANING_CLEANING_FIXTURE_H_

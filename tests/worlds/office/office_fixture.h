// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_WORLDS_OFFICE_OFFICE_FIXTURE_H_
#define LATCHWORK_TESTS_WORLDS_OFFICE_OFFICE_FIXTURE_H_

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/worlds/office/shipped_folder.h"
#include "worlds/office/office_world.h"

namespace latchwork::office {

/// An office with its batches, told what to do by hand.
class OfficeFixture : public testing::Test {
 protected:
  using Fact = logic::Fact;
  using Term = logic::Term;

  logic::Diagnostics Load(const std::vector<std::pair<std::string, std::string>>& values,
                          std::uint64_t seed = 1) {
    std::vector<sdk::Parameters::Given> given;
    for (const auto& [name, value] : values) given.push_back({name, value, {"agent.xml", 3, 5}});
    logic::Diagnostics diagnostics;
    const auto parameters = sdk::Parameters::Check(world_.parameters(), given, "office",
                                                   {"agent.xml", 2, 1}, diagnostics);
    if (!diagnostics.empty()) return diagnostics;
    return world_.Load({seed, 0.1, ShippedFolder(), &symbols_}, parameters);
  }

  void Tick(std::vector<Fact> drive, std::vector<Fact> buttons = {}) {
    std::vector<sdk::Batch> effectors(kEffectorPorts);
    effectors[kDrive] = {true, std::move(drive)};
    effectors[kButtons] = {true, std::move(buttons)};
    world_.Observe(tick_, sensors_);
    world_.Apply(tick_, effectors);
    world_.Step(tick_++);
  }

  /// Drives straight to a place; false when it does not get there.
  bool DriveTo(Point goal) {
    for (int i = 0; i < 900; ++i) {
      const Pose pose = world_.state().vehicle->pose();
      if (Distance(PointOf(pose), goal) < 0.06) return true;
      const double turn = WrapAngle(std::atan2(goal.y - pose.y, goal.x - pose.x) - pose.heading);
      const double speed = std::abs(turn) < 0.1 ? 0.4 : 0.0;
      Tick({Make("turn", {Term::Real(turn)}), Make("fwd", {Term::Real(speed)})});
      if (world_.outcome().state != sdk::Outcome::State::kRunning) return false;
    }
    return false;
  }

  Fact Make(const char* name, std::initializer_list<Term> terms) {
    return {symbols_.Intern(name), terms};
  }
  Term Word(const char* name) { return Term::Constant(symbols_.Intern(name)); }
  Point PlaceOf(const char* name) {
    const Building& building = world_.state().building;
    return building.landmarks[*building.FindLandmark(name)].place;
  }
  /// Whether a port says something new, and what.
  bool Updated(SensorPort port) const { return sensors_[port].updated; }
  std::string Sensed(SensorPort port) const {
    std::string text;
    for (const Fact& fact : sensors_[port].facts) text += logic::ToString(fact) + " ";
    return text;
  }

  logic::SymbolTable symbols_;
  OfficeWorld world_;
  std::vector<sdk::Batch> sensors_ = std::vector<sdk::Batch>(kSensorPorts);
  std::uint64_t tick_ = 0;
};

}  // namespace latchwork::office

#endif  // LATCHWORK_TESTS_WORLDS_OFFICE_OFFICE_FIXTURE_H_

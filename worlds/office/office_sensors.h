// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_OFFICE_SENSORS_H_
#define LATCHWORK_OFFICE_OFFICE_SENSORS_H_

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/world.h"
#include "worlds/office/office_state.h"

namespace latchwork::office {

/// Says what the sensors of the office perceive, as facts. What never changes is said once, sonar
/// and pose in every tick, the rest when it changes. Thread rule: used by one thread.
class OfficeSensors {
 public:
  explicit OfficeSensors(logic::SymbolTable& symbols);

  /// One batch for each SensorPort; batches of sensors with nothing new are left as they are, with
  /// `updated` false.
  void Observe(std::uint64_t tick, OfficeState& state, std::span<sdk::Batch> sensors);

 private:
  using Facts = std::vector<logic::Fact>;
  struct Cab {
    int floor = 0;
    bool open = false;
    bool in_service = true;
    bool inside = false;
    friend bool operator==(const Cab&, const Cab&) = default;
  };

  void SaySonar(std::uint64_t tick, OfficeState& state, Facts& facts) const;
  void SayRobot(const OfficeState& state, Facts& facts) const;
  void SayPose(std::uint64_t tick, OfficeState& state, Facts& facts) const;
  void SayPlace(const OfficeState& state, sdk::Batch& batch);
  void SayBuilding(const Building& building, Facts& facts) const;
  void SayElevators(const OfficeState& state, sdk::Batch& batch);
  void SayDoors(const OfficeState& state, sdk::Batch& batch);
  void SayGoal(const OfficeState& state, sdk::Batch& batch);
  void SayDestination(const OfficeState& state, sdk::Batch& batch);

  logic::Symbol sonar_reading_, no_echo_, sonar_direction_, robot_radius_, curr_location_,
      curr_heading_, curr_floor_, curr_landmark_, landmark_, adjacent_, elevator_, elevator_front_,
      cab_, elevator_at_, elevator_open_, elevator_out_of_order_, inside_, door_shut_, goal_,
      move_cmd_;

  bool first_ = true;
  std::optional<std::size_t> said_place_;
  std::vector<Cab> said_cabs_;
  std::vector<Cab> cabs_;
  std::vector<char> said_shut_;
  std::optional<std::size_t> said_goal_;
  std::uint64_t said_destination_ = 0;
};

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_OFFICE_SENSORS_H_

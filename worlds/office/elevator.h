// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_ELEVATOR_H_
#define LATCHWORK_OFFICE_ELEVATOR_H_

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "latchwork/sdk/random.h"

namespace latchwork::office {

/// Times in seconds.
struct ElevatorOptions {
  double door_time = 2.0;        ///< To open or to close.
  double dwell_time = 6.0;       ///< Open without anybody in the door.
  double floor_time = 5.0;       ///< From one floor to the next.
  double calls_per_hour = 30.0;  ///< Of other people, for each elevator.
};

/// One elevator: a cab, a door and a queue. Floors are indices from 0. The door is open on no floor
/// but the cab's; it opens again when its light curtain is broken. An elevator that goes out of
/// order stops at the next floor, opens if the robot is inside, and stays. Thread rule: used by one
/// thread.
class Elevator {
 public:
  enum class Door : std::uint8_t { kClosed, kOpening, kOpen, kClosing };

  Elevator(const ElevatorOptions& options, int floors, double tick_seconds, std::uint64_t seed,
           std::string_view name);

  int floor() const { return floor_; }  ///< While it travels: the floor it left or passed last.
  Door door() const { return door_; }
  /// Shut for bodies: from the moment it has closed until it is fully open.
  bool is_shut() const { return shut_; }
  bool in_service() const { return in_service_; }
  void PutAt(int floor) { floor_ = floor; }

  /// The button on a floor, or the one for a floor in the cab.
  void Call(int floor);
  void SetInService(bool in_service) { in_service_ = in_service; }

  /// One tick. `curtain_broken`: the robot is in the door; `occupied`: it is in the cab. True when
  /// the cab has come to another floor.
  bool Step(std::uint64_t tick, bool curtain_broken, bool occupied);

 private:
  void OtherPeople(std::uint64_t tick);
  void Serve();
  bool Travel(bool occupied);
  void StepDoor(std::uint64_t tick, bool curtain_broken, bool occupied);
  void SendPassenger(std::uint64_t tick);
  std::optional<int> NextCall() const;
  bool IsCalled(int floor) const { return calls_[static_cast<std::size_t>(floor)] != 0; }
  void Clear(int floor) { calls_[static_cast<std::size_t>(floor)] = 0; }

  int door_ticks_;
  int dwell_ticks_;
  int floor_ticks_;
  double call_probability_;
  sdk::RandomStream random_;
  std::vector<char> calls_;
  std::vector<char> strangers_;  ///< Floors on which somebody else waits.
  int floor_ = 0;
  int direction_ = 0;
  int last_direction_ = 1;
  int timer_ = 0;
  Door door_ = Door::kClosed;
  bool in_service_ = true;
  bool shut_ = true;
};

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_ELEVATOR_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_VEHICLE_H_
#define LATCHWORK_OFFICE_VEHICLE_H_

#include <optional>
#include <span>
#include <string>

#include "worlds/office/floor_map.h"
#include "worlds/office/geometry.h"
#include "worlds/office/sonar.h"

namespace latchwork::office {

/// Sizes and limits of the robot.
struct VehicleOptions {
  double radius = 0.25;                               ///< m
  double max_speed = 0.6;                             ///< m/s
  double acceleration = 1.0;                          ///< m/s2
  double brake = 1.5;                                 ///< m/s2
  double max_turn_rate = std::numbers::pi / 2.0;      ///< rad/s
  double turn_acceleration = 2.0 * std::numbers::pi;  ///< rad/s2
};

/// Where the robot ran into something.
struct Contact {
  Point place;       ///< The robot's centre.
  std::string with;  ///< "a wall", "a person"
};

/// A round robot with differential drive: speed and turn rate follow what it is told within its
/// accelerations, and it moves along exact arcs. It stops where it touches, never passes through.
/// Thread rule: used by one thread.
class Vehicle {
 public:
  Vehicle(const VehicleOptions& options, double tick_seconds)
      : options_(options), dt_(tick_seconds) {}

  void Place(const Pose& pose);
  const VehicleOptions& options() const { return options_; }
  const Pose& pose() const { return pose_; }
  double speed() const { return speed_; }
  double turn_rate() const { return turn_rate_; }
  /// Way travelled since Place, m.
  double travelled() const { return travelled_; }

  /// What to do from now on. No speed: roll out and stop; a speed of 0 brakes.
  void Forward(std::optional<double> speed) { wanted_speed_ = speed.value_or(0.0); }
  /// Turns by an angle from the present heading, slowing down before its end; nothing: stops
  /// turning.
  void Turn(std::optional<double> angle);

  /// One tick. Returns a contact when the robot was stopped by one; it then stands still.
  std::optional<Contact> Step(const FloorMap& map, std::span<const Disc> discs);

 private:
  void Accelerate(double dt);
  double WantedTurnRate() const;
  Pose Advance(double dt) const;
  std::optional<Contact> Touches(const FloorMap& map, std::span<const Disc> discs,
                                 const Pose& pose) const;

  VehicleOptions options_;
  double dt_;
  Pose pose_;
  double speed_ = 0.0;
  double turn_rate_ = 0.0;
  double travelled_ = 0.0;
  double wanted_speed_ = 0.0;
  std::optional<double> wanted_heading_;
};

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_VEHICLE_H_

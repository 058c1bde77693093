// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CLEANING_BATTERY_H_
#define LATCHWORK_CLEANING_BATTERY_H_

#include <algorithm>
#include <cmath>

namespace latchwork::cleaning {

/// Powers in W, of the battery's contents in J.
struct BatteryOptions {
  double capacity = 30000;
  double idle_power = 8;    ///< Always.
  double brush_power = 22;  ///< Off the dock.
  double drive_power = 40;  ///< For each m/s.
  double dock_power = 300;  ///< What the dock gives.
};

/// What the robot lives on.
class Battery {
 public:
  explicit Battery(const BatteryOptions& options)
      : options_(options), energy_(options.capacity), lowest_(options.capacity) {}

  void Step(double dt, double speed, bool docked) {
    double power = -options_.idle_power - options_.drive_power * std::abs(speed);
    power += docked ? options_.dock_power : -options_.brush_power;
    energy_ = std::clamp(energy_ + power * dt, 0.0, options_.capacity);
    lowest_ = std::min(lowest_, energy_);
  }

  double charge() const { return energy_ / options_.capacity; }  ///< 0 to 1.
  double lowest_charge() const { return lowest_ / options_.capacity; }
  bool is_empty() const { return energy_ <= 0.0; }

 private:
  BatteryOptions options_;
  double energy_;
  double lowest_;
};

}  // namespace latchwork::cleaning

#endif  // LATCHWORK_CLEANING_BATTERY_H_

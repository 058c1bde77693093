// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_LOCALIZATION_H_
#define LATCHWORK_OFFICE_LOCALIZATION_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "latchwork/sdk/random.h"
#include "worlds/office/building.h"

namespace latchwork::office {

/// Which landmark the robot is at: the last one whose zone its centre entered on this floor; at
/// first the nearest that it sees along a free straight line; in a cab the cab's. Thread rule: used
/// by one thread.
class LandmarkTracker {
 public:
  explicit LandmarkTracker(const Building& building) : building_(&building) {}

  /// `maps` are the floors of this run, `radius` the robot's.
  void Reset(std::span<const FloorMap> maps, int floor, Point place, double radius);
  void Update(int floor, Point place);
  std::optional<std::size_t> current() const { return current_; }

 private:
  const Building* building_;
  std::optional<std::size_t> current_;
};

/// The elevator whose cab rectangle holds the place.
std::optional<std::size_t> CabAt(const Building& building, Point place);

/// Where the robot believes to be: the true pose, plus an error that walks at random with the way
/// travelled.
class Odometry {
 public:
  /// `noise`: standard deviation of the error after one metre, m; its heading part is a tenth of
  /// it, in rad.
  Odometry(double noise, std::uint64_t seed) : noise_(noise), random_(seed, "odometry") {}
  Pose Read(const Pose& truth, double travelled, std::uint64_t tick);

 private:
  double noise_;
  sdk::RandomStream random_;
  double travelled_ = 0.0;
  Pose error_;
};

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_LOCALIZATION_H_

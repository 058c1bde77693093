// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_DESTINATIONS_H_
#define LATCHWORK_OFFICE_DESTINATIONS_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "latchwork/sdk/random.h"
#include "worlds/office/floor_map.h"
#include "worlds/office/geometry.h"

namespace latchwork::office {

/// Places to go, one after the other, by seed: each 2 to 15 m away from the robot, on ground that
/// it can reach within 15 m of where it is, with 0.6 m free all round where there is such a place.
/// A new one comes when the robot is within 0.6 m of the last, or after 60 s. Thread rule: used by
/// one thread.
class Destinations {
 public:
  /// `radius` is the robot's, in metres.
  Destinations(std::uint64_t seed, double radius, double tick_seconds);

  /// To be called once in every tick, with the robot's floor as it stands and its place.
  void Update(const FloorMap& map, Point robot);

  /// Nothing where no place can be reached.
  std::optional<Point> current() const { return current_; }
  /// Changes when `current` does.
  std::uint64_t version() const { return version_; }
  std::uint64_t reached() const { return reached_; }

 private:
  void Pick(const FloorMap& map, Point robot);
  void Explore(const FloorMap& map, Point robot, double radius);

  sdk::RandomStream random_;
  double radius_;
  std::uint64_t patience_;  ///< Ticks.
  std::uint64_t waited_ = 0;
  std::uint64_t version_ = 0;
  std::uint64_t reached_ = 0;
  std::optional<Point> current_;
  std::vector<Point> reachable_;
};

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_DESTINATIONS_H_

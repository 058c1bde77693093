// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_DESTINATIONS_H_
#define LATCHWORK_OFFICE_DESTINATIONS_H_

#include <cstdint>

#include "latchwork/sdk/random.h"
#include "worlds/office/floor_map.h"
#include "worlds/office/geometry.h"

namespace latchwork::office {

/// Places for a robot without a plan to seek: each in sight of where the robot was when it was
/// named, by seed. Another one when a place is reached, or after a minute. Thread rule: used by one
/// thread.
class Destinations {
 public:
  /// `radius`: of the robot, m.
  Destinations(std::uint64_t seed, double radius, double tick_seconds);

  /// The place to seek at this tick; the robot's own where nothing free is in sight.
  Point At(std::uint64_t tick, const FloorMap& map, Point robot);

 private:
  Point Choose(std::uint64_t tick, const FloorMap& map, Point robot) const;

  sdk::RandomStream random_;
  double radius_;
  std::uint64_t patience_;
  std::uint64_t since_ = 0;
  bool chosen_ = false;
  Point place_;
};

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_DESTINATIONS_H_

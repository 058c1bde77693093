// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_SONAR_H_
#define LATCHWORK_OFFICE_SONAR_H_

#include <cstdint>
#include <span>
#include <vector>

#include "latchwork/sdk/random.h"
#include "worlds/office/floor_map.h"
#include "worlds/office/geometry.h"

namespace latchwork::office {

struct SonarOptions {
  int count = 16;
  double cone = 25.0 * std::numbers::pi / 180.0;  ///< Full opening angle, rad.
  int rays = 11;                                  ///< In a cone, symmetric about its axis.
  double min_range = 0.05;                        ///< m; nearer echoes read as this.
  double max_range = 5.0;                         ///< m
  double mount_radius = 0.25;                     ///< From the robot's centre, m.
  double noise = 0.0;                             ///< Standard deviation, m.
  double missed = 0.0;                            ///< Probability that an echo is not heard.
};

/// A round thing that stands or moves in the way of sound.
struct Disc {
  Point centre;
  double radius = 0.0;
};

/// A ring of sonars: number 0 points ahead, numbers run counter-clockwise. A reading is the
/// shortest ray of a cone that is symmetric about its axis, so a mirrored world gives mirrored
/// readings. Distances count from the sonar, at the rim. Thread rule: used by one thread.
class SonarRing {
 public:
  SonarRing(const SonarOptions& options, std::uint64_t seed);

  /// One reading for each sonar, m; infinity where no echo was heard. The span lives until the next
  /// call.
  std::span<const double> Read(const FloorMap& map, const Pose& pose, std::span<const Disc> discs,
                               std::uint64_t tick);
  int size() const { return options_.count; }
  /// Direction of a sonar relative to straight ahead, rad, in (-pi, pi].
  double BearingOf(int sonar) const;
  /// A sonar that failed hears nothing.
  void SetFailed(int sonar, bool failed) {
    failed_[static_cast<std::size_t>(sonar)] = failed ? 1 : 0;
  }

 private:
  double Cone(const FloorMap& map, Point from, double axis) const;
  double Hear(double distance, std::uint64_t tick, std::uint64_t sonar) const;

  SonarOptions options_;
  sdk::RandomStream noise_;
  sdk::RandomStream missed_;
  std::vector<double> readings_;
  std::vector<char> failed_;
  std::vector<Disc> near_;
};

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_SONAR_H_

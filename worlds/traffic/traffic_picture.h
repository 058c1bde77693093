// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TRAFFIC_TRAFFIC_PICTURE_H_
#define LATCHWORK_TRAFFIC_TRAFFIC_PICTURE_H_

#include <cstddef>
#include <filesystem>
#include <vector>

#include "latchwork/sdk/svg.h"
#include "worlds/traffic/road.h"

namespace latchwork::traffic {

/// Remembers the first minutes of a run, twice a second, and draws them: the road around the
/// agent's car as it moves along, and below it lane and speed over the way.
class TrafficPicture {
 public:
  void Begin(const RoadSetup& setup, double exit);
  /// `distance` is driven since the start of the run, `travelled` since that of the trip, in m.
  void Remember(double seconds, double distance, double travelled, const Road& road);
  std::vector<std::filesystem::path> Draw(const std::filesystem::path& folder) const;

 private:
  struct Seen {
    std::size_t car = 0;
    double x = 0;  ///< m ahead of the agent's car
    double y = 0;
    double length = 0;
  };
  struct Frame {
    double seconds = 0;
    double distance = 0;
    double speed = 0;
    double y = 0;
    std::vector<Seen> cars;
  };

  void DrawRoad(sdk::Svg& svg) const;
  void DrawCars(sdk::Svg& svg) const;
  /// One stay of a car in the picture, from one frame to another; the next frame to look at.
  std::size_t DrawStay(sdk::Svg& svg, std::size_t car, std::size_t first) const;
  void DrawAgent(sdk::Svg& svg) const;
  void DrawChart(sdk::Svg& svg) const;
  const Seen* Find(std::size_t frame, std::size_t car) const;
  double RoadHeight() const { return lanes_ * kLaneWidth; }
  double ChartX(double distance) const;

  int lanes_ = 1;
  double speed_limit_ = 30;
  double exit_ = 0;
  std::size_t car_count_ = 0;
  double next_at_ = 0;
  std::vector<double> exits_;  ///< m from the start of the run
  std::vector<Frame> frames_;
};

}  // namespace latchwork::traffic

#endif  // LATCHWORK_TRAFFIC_TRAFFIC_PICTURE_H_

// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/localization.h"

#include <cmath>
#include <limits>

#include "worlds/office/collision.h"

namespace latchwork::office {

std::optional<std::size_t> CabAt(const Building& building, Point place) {
  for (std::size_t i = 0; i < building.elevators.size(); ++i) {
    if (building.elevators[i].cab.Contains(place)) return i;
  }
  return std::nullopt;
}

void LandmarkTracker::Reset(std::span<const FloorMap> maps, int floor, Point place, double radius) {
  current_.reset();
  double nearest = std::numeric_limits<double>::infinity();
  const FloorMap& map = maps[static_cast<std::size_t>(floor)];
  for (std::size_t i = 0; i < building_->landmarks.size(); ++i) {
    const Landmark& landmark = building_->landmarks[i];
    const double distance = Distance(landmark.place, place);
    if (landmark.floor != floor || distance >= nearest) continue;
    if (!IsLineFree(map, place, landmark.place, radius)) continue;
    nearest = distance;
    current_ = i;
  }
  Update(floor, place);
}

void LandmarkTracker::Update(int floor, Point place) {
  if (const auto cab = CabAt(*building_, place)) {
    current_ = building_->elevators[*cab].cab_landmark;
    return;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < building_->landmarks.size(); ++i) {
    const Landmark& landmark = building_->landmarks[i];
    if (landmark.floor != floor) continue;
    const double distance = Distance(landmark.place, place);
    if (distance > landmark.zone || distance >= nearest) continue;
    nearest = distance;
    current_ = i;
  }
}

Pose Odometry::Read(const Pose& truth, double travelled, std::uint64_t tick) {
  if (noise_ <= 0.0) return truth;
  const double spread = noise_ * std::sqrt(std::max(0.0, travelled - travelled_));
  travelled_ = travelled;
  error_.x += spread * random_.Gaussian(tick, 0);
  error_.y += spread * random_.Gaussian(tick, 1);
  error_.heading += 0.1 * spread * random_.Gaussian(tick, 2);
  return {truth.x + error_.x, truth.y + error_.y, WrapAngle(truth.heading + error_.heading)};
}

}  // namespace latchwork::office

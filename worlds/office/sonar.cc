// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/sonar.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace latchwork::office {

namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

double CastAtDisc(Point from, Point direction, const Disc& disc) {
  const double dx = disc.centre.x - from.x;
  const double dy = disc.centre.y - from.y;
  const double along = dx * direction.x + dy * direction.y;
  const double squared = disc.radius * disc.radius - (dx * dx + dy * dy - along * along);
  if (squared < 0.0) return kNothing;
  const double half = std::sqrt(squared);
  if (along + half < 0.0) return kNothing;
  return std::max(0.0, along - half);
}

}  // namespace

SonarRing::SonarRing(const SonarOptions& options, std::uint64_t seed)
    : options_(options), noise_(seed, "sonar noise"), missed_(seed, "sonar missed") {
  readings_.resize(static_cast<std::size_t>(options.count), kNothing);
  failed_.resize(readings_.size(), 0);
}

double SonarRing::BearingOf(int sonar) const {
  // Bearings left and right of straight ahead are exact negatives of each other.
  const bool right = 2 * sonar > options_.count;
  const int step = right ? options_.count - sonar : sonar;
  const double bearing = 2.0 * std::numbers::pi * step / options_.count;
  return right ? -bearing : bearing;
}

std::span<const double> SonarRing::Read(const FloorMap& map, const Pose& pose,
                                        std::span<const Disc> discs, std::uint64_t tick) {
  near_.clear();
  for (const Disc& disc : discs) {
    const double reach = options_.max_range + options_.mount_radius + disc.radius;
    if (Distance(disc.centre, PointOf(pose)) < reach) near_.push_back(disc);
  }
  for (int n = 0; n < options_.count; ++n) {
    const auto index = static_cast<std::size_t>(n);
    readings_[index] = kNothing;
    if (failed_[index] != 0) continue;
    const double axis = pose.heading + BearingOf(n);
    const Point from{pose.x + options_.mount_radius * std::cos(axis),
                     pose.y + options_.mount_radius * std::sin(axis)};
    readings_[index] = Hear(Cone(map, from, axis), tick, index);
  }
  return readings_;
}

double SonarRing::Cone(const FloorMap& map, Point from, double axis) const {
  double nearest = kNothing;
  const int last = options_.rays - 1;
  for (int ray = 0; ray <= last; ++ray) {
    // (2 ray - last) is an odd function of the ray's place in the fan: offsets mirror exactly.
    const double offset = last == 0 ? 0.0 : options_.cone / 2.0 * (2 * ray - last) / last;
    const double angle = axis + offset;
    nearest = std::min(nearest, map.CastRay(from, angle, options_.max_range));
    if (near_.empty()) continue;
    const Point direction{std::cos(angle), std::sin(angle)};
    for (const Disc& disc : near_) nearest = std::min(nearest, CastAtDisc(from, direction, disc));
  }
  return nearest <= options_.max_range ? nearest : kNothing;
}

double SonarRing::Hear(double distance, std::uint64_t tick, std::uint64_t sonar) const {
  if (distance == kNothing) return kNothing;
  if (options_.missed > 0.0 && missed_.Uniform(tick, sonar) < options_.missed) return kNothing;
  if (options_.noise > 0.0) distance += options_.noise * noise_.Gaussian(tick, sonar);
  return std::clamp(distance, options_.min_range, options_.max_range);
}

}  // namespace latchwork::office

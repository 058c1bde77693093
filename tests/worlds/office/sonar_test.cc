// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/sonar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/worlds/office/test_map.h"

namespace latchwork::office {
namespace {

std::vector<double> Read(const SonarOptions& options, const Cells& cells, const Pose& pose,
                         std::span<const Disc> discs = {}, std::uint64_t seed = 1) {
  SonarRing ring(options, seed);
  const auto readings = ring.Read(FloorMap(cells), pose, discs, 7);
  return {readings.begin(), readings.end()};
}

Cells MirroredInX(Cells cells) {
  for (int y = 0; y < cells.height; ++y) {
    const auto first = cells.occupied.begin() + static_cast<std::ptrdiff_t>(y) * cells.width;
    std::reverse(first, first + cells.width);
  }
  return cells;
}

TEST(SonarTest, WallAhead_ReadsDistanceFromTheRim) {
  const auto readings = Read({}, Hall(), {3.0, 2.0, std::numbers::pi});
  EXPECT_NEAR(readings[0], 2.65, 0.08);
}

TEST(SonarTest, MirroredWorld_GivesMirroredReadingsToTheBit) {
  for (const double heading : {0.3, 1.234, -2.5}) {
    const Pose pose{4.813, 2.377, heading};
    const Pose mirrored{10.0 - pose.x, pose.y, WrapAngle(std::numbers::pi - heading)};
    const auto a = Read({}, Hall(), pose);
    const auto b = Read({}, MirroredInX(Hall()), mirrored);
    // The ring of a mirrored robot: left and right change places. Positions mirror up to rounding,
    // and MRPT steps rays in 1/1024 of a cell, so equal steps are taken and the readings agree
    // exactly.
    for (std::size_t n = 0; n < a.size(); ++n) EXPECT_EQ(a[n], b[(16 - n) % 16]) << n;
  }
}

TEST(SonarTest, PostAnywhereInTheCone_IsHeard) {
  for (int degrees = -12; degrees <= 12; degrees += 2) {
    const double bearing = degrees * std::numbers::pi / 180.0;
    const Pose pose{5.0, 4.0, -bearing};
    EXPECT_NEAR(Read({}, Hall(), pose)[0], 1.65, 0.1) << degrees;
  }
}

TEST(SonarTest, NothingInRange_IsInfinite) {
  SonarOptions options;
  options.max_range = 1.0;
  for (const double reading : Read(options, Hall(), {4.0, 3.0, 0.0})) {
    EXPECT_TRUE(std::isinf(reading));
  }
}

TEST(SonarTest, Person_IsHeardUnlessBehindAWall) {
  const std::array<Disc, 1> near{Disc{{5.0, 3.0}, 0.2}};
  const std::array<Disc, 1> behind{Disc{{7.6, 4.0}, 0.05}};
  EXPECT_NEAR(Read({}, Hall(), {3.0, 3.0, 0.0}, near)[0], 1.55, 1e-2);
  const Pose before_post{5.0, 4.0, 0.0};
  EXPECT_EQ(Read({}, Hall(), before_post, behind)[0], Read({}, Hall(), before_post)[0]);
}

TEST(SonarTest, Noise_FollowsTheSeedAndHasItsDeviation) {
  SonarOptions options;
  options.noise = 0.05;
  const Pose pose{3.0, 2.0, std::numbers::pi};
  EXPECT_EQ(Read(options, Hall(), pose, {}, 3), Read(options, Hall(), pose, {}, 3));
  EXPECT_NE(Read(options, Hall(), pose, {}, 3), Read(options, Hall(), pose, {}, 4));
  const double exact = Read({}, Hall(), pose)[0];
  double sum = 0.0;
  double squares = 0.0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const double error = Read(options, Hall(), pose, {}, seed)[0] - exact;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(sum / 400, 0.0, 0.01);
  EXPECT_NEAR(std::sqrt(squares / 400), 0.05, 0.01);
}

TEST(SonarTest, EveryEchoMissed_ReadsNothing) {
  SonarOptions options;
  options.missed = 1.0;
  for (const double reading : Read(options, Hall(), {3.0, 2.0, 0.0})) {
    EXPECT_TRUE(std::isinf(reading));
  }
}

}  // namespace
}  // namespace latchwork::office

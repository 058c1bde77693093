// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/floor_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <queue>

#include "tests/temporary_folder.h"
#include "tests/worlds/office/shipped_folder.h"
#include "tests/worlds/office/test_map.h"
#include "worlds/office/collision.h"

namespace latchwork::office {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

const std::string kPixels("\xff\xff\x00\xcd\xff\xff", 6);  // top row first

std::string Slurp(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(FloorMapTest, WallAhead_RayMeasuresWithinTwoSteps) {
  const FloorMap map{Hall()};
  const double distance = map.CastRay({5.0, 2.0}, std::numbers::pi, 6.0);
  EXPECT_GE(distance, 4.9 - 1e-6);
  EXPECT_LE(distance, 4.9 + 0.08);
}

TEST(FloorMapTest, WallJustInRange_IsHeard) {
  const FloorMap map{Hall()};
  EXPECT_TRUE(std::isfinite(map.CastRay({5.0, 2.0}, std::numbers::pi, 4.98)));
  EXPECT_FALSE(std::isfinite(map.CastRay({5.0, 2.0}, std::numbers::pi, 4.8)));
}

TEST(FloorMapTest, CoveredTwice_StaysUntilUncoveredTwice) {
  FloorMap map{Hall()};
  map.Cover(50, 50);
  map.Cover(50, 50);
  map.Uncover(50, 50);
  EXPECT_TRUE(map.IsOccupied(50, 50));
  map.Uncover(50, 50);
  EXPECT_FALSE(map.IsOccupied(50, 50));
}

TEST(FloorMapTest, Copy_SharesNothing) {
  const FloorMap map{Hall()};
  FloorMap copy = map;
  copy.Cover(50, 50);
  EXPECT_FALSE(map.IsOccupied(50, 50));
  EXPECT_TRUE(std::isfinite(copy.CastRay({1.0, 2.52}, 0.0, 3.0)));
  EXPECT_FALSE(std::isfinite(map.CastRay({1.0, 2.52}, 0.0, 3.0)));
}

TEST(FloorMapTest, Outside_IsOccupied) {
  const FloorMap map{Hall()};
  EXPECT_TRUE(map.IsOccupied(-1, 5));
  EXPECT_TRUE(map.IsOccupied(5, 120));
}

TEST(LoadCellsTest, ShippedFloor_HasItsSize) {
  const auto loaded = LoadCells(ShippedFolder() / "data/building/floor1.png", 0.05);
  ASSERT_TRUE(loaded.cells) << loaded.error;
  EXPECT_EQ(loaded.cells->width, 880);
  EXPECT_EQ(loaded.cells->height, 560);
}

TEST(LoadCellsTest, YamlWithPgm_MarksUnknownOccupied) {
  const TemporaryFolder folder;
  folder.Write("m.pgm", "P5\n# made by a test\n3 2\n255\n" + kPixels);
  const auto yaml = folder.Write("m.yaml",
                                 "image: m.pgm\nresolution: 0.1  # m\norigin: [-1.5, 2, 0.0]\n"
                                 "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const auto loaded = LoadCells(yaml, 0.05);
  ASSERT_TRUE(loaded.cells) << loaded.error;
  EXPECT_EQ(loaded.cells->occupied, (std::vector<std::uint8_t>{1, 0, 0, 0, 0, 1}));
  EXPECT_DOUBLE_EQ(loaded.cells->resolution, 0.1);
  EXPECT_DOUBLE_EQ(loaded.cells->origin.x, -1.5);
}

TEST(LoadCellsTest, NegatedYaml_TurnsColoursRound) {
  const TemporaryFolder folder;
  folder.Write("m.pgm", "P2 2 2 255 0 255 255 0");
  const auto yaml =
      folder.Write("m.yaml", "image: m.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 1\n");
  const auto loaded = LoadCells(yaml, 0.05);
  ASSERT_TRUE(loaded.cells) << loaded.error;
  EXPECT_EQ(loaded.cells->occupied, (std::vector<std::uint8_t>{1, 0, 0, 1}));
}

TEST(LoadCellsTest, PictureOf800x800_KeepsItsResolution) {
  const TemporaryFolder folder;
  const auto file = folder.Write("m.pgm", "P5 800 800 255\n" + std::string(640000, '\xff'));
  const auto loaded = LoadCells(file, 0.2);
  ASSERT_TRUE(loaded.cells) << loaded.error;
  const FloorMap map(*loaded.cells);
  EXPECT_EQ(map.CellX(159.9), 799);
  EXPECT_FALSE(map.IsOccupied(799, 799));
}

struct BadFile {
  std::string name;
  std::string text;
  std::string message;
};

class BadMapTest : public testing::TestWithParam<BadFile> {};

TEST_P(BadMapTest, Malformed_IsRefusedWithMessage) {
  const TemporaryFolder folder;
  folder.Write("good.pgm", "P5 3 2 255\n" + kPixels);
  const auto file = folder.Write(GetParam().name, GetParam().text);
  const auto loaded = LoadCells(file, 0.05);
  EXPECT_FALSE(loaded.cells);
  EXPECT_THAT(loaded.error, HasSubstr(GetParam().message));
  EXPECT_THAT(loaded.error, HasSubstr(GetParam().name));
}

const std::string kYaml = "image: good.pgm\nresolution: 0.1\n";

INSTANTIATE_TEST_SUITE_P(
    All, BadMapTest,
    testing::Values(
        BadFile{"a.pgm", "P5 3 2 255\nab", "cut short"},
        BadFile{"b.pgm", "P5 99999 99999 255\n", "cells"}, BadFile{"c.pgm", "P6 1 1", "not a PGM"},
        BadFile{"d.pgm", "P5 x 2 255\n", "header is damaged"},
        BadFile{"e.pgm", "P2 20000 3000 255 1 2", "cut short"},
        BadFile{"f.pgm", "P5 0 2 255\n", "empty"}, BadFile{"a.png", "hello", "not a PNG"},
        BadFile{"a.gridmap", "hello", "not an MRPT occupancy grid"},
        BadFile{"a.simplemap.gz", "hello", "not an MRPT simplemap"},
        BadFile{"a.txt", "hello", "not a known kind of map"},
        BadFile{"a.yaml", kYaml + "origin: [0, 0, 0.5]\n", "a.yaml:3:9: the yaw"},
        BadFile{"b.yaml", kYaml, "'origin' is missing"},
        BadFile{"c.yaml", "image: good.pgm\nresolution: -1\n", "c.yaml:2:13: 'resolution'"},
        BadFile{"d.yaml", kYaml + "origin: [0, nan, 0]\n", "finite"},
        BadFile{"e.yaml", kYaml + "origin: [0, 0, 0]\nmode: blue\n", "e.yaml:4:7: 'mode'"},
        BadFile{"f.yaml", "just words\n", "f.yaml:1:1: expected"}));

TEST(LoadCellsTest, CutPng_IsRefused) {
  const TemporaryFolder folder;
  const std::string whole = Slurp(ShippedFolder() / "data/building/floor1.png");
  EXPECT_THAT(LoadCells(folder.Write("a.png", whole.substr(0, 1000)), 0.05).error,
              HasSubstr("cut short"));
  std::string damaged = whole;
  damaged[500] = static_cast<char>(damaged[500] ^ 1);
  EXPECT_THAT(LoadCells(folder.Write("b.png", damaged), 0.05).error, HasSubstr("checksum"));
}

TEST(LoadCellsTest, MissingFile_IsRefused) {
  EXPECT_THAT(LoadCells("/nowhere/at_all.png", 0.05).error, HasSubstr("no such file"));
}

TEST(LoadCellsTest, AbsurdResolution_IsRefused) {
  const auto file = ShippedFolder() / "data/building/floor1.png";
  EXPECT_THAT(LoadCells(file, 0.0).error, HasSubstr("resolution"));
}

/// The free area that a disc reaches from a place, in square metres, on a lattice of 0.2 m.
double ReachableArea(const FloorMap& map, Point from, double radius) {
  constexpr double kStep = 0.2;
  std::vector<std::vector<char>> seen(400, std::vector<char>(400, 0));
  std::queue<std::pair<int, int>> open;
  open.emplace(200, 200);
  seen[200][200] = 1;
  int count = 0;
  while (!open.empty()) {
    const auto [x, y] = open.front();
    open.pop();
    ++count;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const int nx = x + dx;
      const int ny = y + dy;
      if (nx < 0 || ny < 0 || nx >= 400 || ny >= 400) continue;
      char& mark = seen[static_cast<std::size_t>(nx)][static_cast<std::size_t>(ny)];
      const Point place{from.x + (nx - 200) * kStep, from.y + (ny - 200) * kStep};
      if (mark != 0 || FindContact(map, place, radius)) continue;
      mark = 1;
      open.emplace(nx, ny);
    }
  }
  return count * kStep * kStep;
}

class RecordedMapTest : public testing::TestWithParam<std::string> {};

TEST_P(RecordedMapTest, Loads_WithReachableFreeSpace) {
  const std::filesystem::path file = "/usr/share/mrpt/datasets/" + GetParam();
  ASSERT_TRUE(std::filesystem::exists(file)) << "install the package mrpt-common";
  const auto loaded = LoadCells(file, 0.05);
  ASSERT_TRUE(loaded.cells) << loaded.error;
  const FloorMap map(*loaded.cells);
  double best = 0.0;
  for (int i = 1; i < 12; ++i) {
    for (int j = 1; j < 12; ++j) {
      const Point place{map.origin().x + map.width() * map.resolution() * i / 12,
                        map.origin().y + map.height() * map.resolution() * j / 12};
      if (FindContact(map, place, 0.25)) continue;
      best = std::max(best, ReachableArea(map, place, 0.25));
    }
  }
  EXPECT_GT(best, 60.0);
}

INSTANTIATE_TEST_SUITE_P(All, RecordedMapTest,
                         testing::Values("localization_demo.simplemap.gz",
                                         "malaga-cs-fac-building.simplemap.gz",
                                         "uwb_ro-localization_demo_map.gridmap.gz"));

}  // namespace
}  // namespace latchwork::office

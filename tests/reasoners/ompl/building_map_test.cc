// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/map/building_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reasoners/ompl/reasoner_mind.h"
#include "tests/temporary_folder.h"

namespace latchwork::planning {
namespace {

using ::testing::HasSubstr;

TEST(BuildingMapTest, Office_FloorsAndLandmarks) {
  logic::SymbolTable symbols;
  const ReadBuildingMap read = ReadBuilding(kOffice, 0.05, {}, symbols);
  EXPECT_EQ(logic::Format(read.diagnostics), "");
  ASSERT_EQ(read.map.floors.size(), 3U);
  EXPECT_NEAR(read.map.floors.at(1).extent_x(), 44.0, 1e-9);
  EXPECT_NEAR(read.map.floors.at(3).extent_y(), 28.0, 1e-9);
  const Place& corridor = read.map.landmarks.at(symbols.Intern("c1_01"));
  EXPECT_EQ(corridor.floor, 1);
  EXPECT_EQ(corridor.at, (Point{1.4, 7.9}));
  for (const auto& [name, place] : read.map.landmarks) {
    if (place.floor == 0) continue;
    EXPECT_GE(read.map.floors.at(place.floor).Clearance(place.at), 0.4) << name.name();
  }
}

TEST(BuildingMapTest, Mistakes_AllWithTheirPlaces) {
  const test::TemporaryFolder folder;
  const auto file = folder.Write("b.p",
                                 "cnf(a, axiom, floor(1, 'none.png', 0.05)).\n"
                                 "cnf(b, axiom, floor(one, 'none.png', 0.05)).\n"
                                 "cnf(c, axiom, floor(2, 'none.png', 7)).\n"
                                 "cnf(d, axiom, landmark(here, 1, x, 2)).\n"
                                 "cnf(e, axiom, room(r, 1, 0, 0, 1, 1)).\n");
  logic::SymbolTable symbols;
  const auto diagnostics = ReadBuilding(file, 0.05, {}, symbols).diagnostics;
  ASSERT_EQ(diagnostics.size(), 4U);
  EXPECT_EQ(diagnostics[0].place.line, 1U);
  EXPECT_THAT(diagnostics[0].message, HasSubstr("none.png"));
  EXPECT_EQ(diagnostics[3].place.line, 4U);
}

TEST(BuildingMapTest, PictureCutShort_Refused) {
  const test::TemporaryFolder folder;
  const auto file = folder.Write("a.png", "\x89PNG\r\n\x1a\nrest");
  logic::SymbolTable symbols;
  EXPECT_EQ(ReadBuilding(file, 0.05, {}, symbols).diagnostics.size(), 1U);
}

}  // namespace
}  // namespace latchwork::planning

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/formats/lay_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace latchwork::circumscription {
namespace {

using testing::ElementsAre;

constexpr const char* kTwoLayers =
    "c a comment\np lay 2 5\nL 1 avoid\nn 3 slow\nP 2 3 0\nQ 1 0\n-3 1 0\nF 1 0\nB 4 3\n"
    "L 2\nP 1 2 4 0\nZ 5 0\n2 -5 0\n? q c 3 -1 0\n= q yes\nnot read any more\n";

TEST(LayFileTest, ReadsEveryStatement) {
  const LayFile file = ReadLay(kTwoLayers, "a.lay");
  ASSERT_TRUE(file.diagnostics.empty()) << Format(file.diagnostics);
  ASSERT_EQ(file.theory.layers.size(), 2U);
  const TheoryLayer& low = file.theory.layers[0];
  EXPECT_EQ(low.name, "avoid");
  ASSERT_EQ(low.theory.atoms.size(), 2U);
  EXPECT_EQ(low.theory.at(1).role, Role::kFixed);
  EXPECT_EQ(low.theory.at(1).name, "1");
  EXPECT_EQ(low.theory.at(2).level, 2);
  EXPECT_EQ(low.theory.at(2).name, "slow");
  EXPECT_THAT(low.theory.clauses, ElementsAre(ElementsAre(-2, 1)));
  EXPECT_THAT(low.facts, ElementsAre(1));
  EXPECT_THAT(low.bridges, ElementsAre(Bridge{2, 2}));
  const TheoryLayer& high = file.theory.layers[1];
  EXPECT_EQ(high.theory.at(3).role, Role::kVarying);
  EXPECT_THAT(high.theory.clauses, ElementsAre(ElementsAre(1, -3)));
  ASSERT_EQ(file.queries.size(), 1U);
  EXPECT_THAT(file.queries[0].literals, ElementsAre(2, -1));
}

TEST(LayFileTest, WrittenTheories_ReadTheSame) {
  const LayFile file = ReadLay(kTwoLayers, "a.lay");
  const std::string text = WriteLay(file.theory, file.queries);
  const LayFile again = ReadLay(text, "b.lay");
  ASSERT_TRUE(again.diagnostics.empty()) << text << Format(again.diagnostics);
  EXPECT_EQ(WriteLay(again.theory, again.queries), text);
  EXPECT_EQ(again.theory.layers[0].bridges, file.theory.layers[0].bridges);
  EXPECT_EQ(again.theory.layers[1].theory.clauses, file.theory.layers[1].theory.clauses);
}

std::string PlacesOf(const LayFile& file) {
  std::string places;
  for (const auto& diagnostic : file.diagnostics) {
    places +=
        std::to_string(diagnostic.place.line) + ":" + std::to_string(diagnostic.place.column) + " ";
  }
  return places;
}

TEST(LayFileTest, ReportsAllErrorsWithTheirPlaces) {
  const LayFile file = ReadLay(
      "p lay 2 4\n1 0\nL 3\nL 1\nP 1 1 2 0\n1 x 0\nB 1\nB -3 1\nL 2\nP 1 3 4 0\nB 3 1\n"
      "? q b 1 0\nwhat\n",
      "a.lay");
  EXPECT_EQ(PlacesOf(file), "2:1 3:3 6:3 7:1 8:3 11:1 12:5 13:1 ");
}

TEST(LayFileTest, AtomsOfOtherLayers_AreRefusedWhereTheyStand) {
  const LayFile file = ReadLay(
      "p lay 2 3\nL 1\nP 1 1 0\n1 -2 0\nB 1 1\nL 2\nF 1 0\nP 1 2 3 0\n? q c 1 -3 0\n", "a.lay");
  EXPECT_EQ(PlacesOf(file), "4:3 5:3 7:3 9:9 ") << Format(file.diagnostics);
}

TEST(LayFileTest, HeaderBoundsMemory) {
  for (const char* text : {"p lay 2000000000 1\n", "p lay 1 2000000000\n", "p lay 0 0\n"}) {
    EXPECT_EQ(ReadLay(text, "a.lay").diagnostics.size(), 1U) << text;
  }
}

}  // namespace
}  // namespace latchwork::circumscription

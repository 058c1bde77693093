// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/formats/circ_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace latchwork::circumscription {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(CircFileTest, ReadsEveryStatement) {
  const CircFile file = ReadCirc(
      "c a comment\np circ 4 2\nn 1 near(3)\nP 1 1 0\nP 2 2 0\nZ 3 0\nQ 4 0\n-4 1 0\n0\nF 4 -1 0\n"
      "? q c 1 -2 0\n? r b 0\n= q yes\nnot read any more\n",
      "a.circ");
  ASSERT_TRUE(file.diagnostics.empty()) << Format(file.diagnostics);
  EXPECT_EQ(file.theory.at(1).name, "near(3)");
  EXPECT_EQ(file.theory.at(2).level, 2);
  EXPECT_EQ(file.theory.at(3).role, Role::kVarying);
  EXPECT_EQ(file.theory.at(4).role, Role::kFixed);
  EXPECT_THAT(file.theory.clauses, ElementsAre(ElementsAre(-4, 1), ElementsAre()));
  EXPECT_THAT(file.facts, ElementsAre(4, -1));
  ASSERT_EQ(file.queries.size(), 2U);
  EXPECT_THAT(file.queries[0].literals, ElementsAre(1, -2));
  EXPECT_FALSE(file.queries[0].brave);
  EXPECT_TRUE(file.queries[1].brave);
}

TEST(CircFileTest, ReportsAllErrorsWithTheirPlaces) {
  const CircFile file = ReadCirc(
      "p circ 3 1\nP 0 1 0\nZ 2 x 0\nQ 3 3 0\n1 4 0\n1 2\nwhat\n? q c 1 0\n? q c 1 0\n", "a.circ");
  std::string places;
  for (const auto& diagnostic : file.diagnostics) {
    places +=
        std::to_string(diagnostic.place.line) + ":" + std::to_string(diagnostic.place.column) + " ";
  }
  EXPECT_EQ(places, "2:3 3:5 4:5 5:3 6:3 7:1 9:3 ");
}

TEST(CircFileTest, HeaderBoundsMemory) {
  const CircFile file = ReadCirc("p circ 2000000000 0\n", "a.circ");
  ASSERT_EQ(file.diagnostics.size(), 1U);
  EXPECT_THAT(file.diagnostics[0].message, HasSubstr("there cannot be 2000000000 atoms"));
}

TEST(CircFileTest, CountsClausesAndRoles) {
  const CircFile file = ReadCirc("p circ 3 2\nZ 2 0\n1 0\n", "a.circ");
  ASSERT_EQ(file.diagnostics.size(), 2U);
  EXPECT_EQ(file.diagnostics[0].message, "the header announces 2 clauses, but there are 1");
  EXPECT_EQ(file.diagnostics[1].message, "2 atoms have no place in P, Z or Q, the first of them 1");
}

TEST(CircFileTest, FactsOverOtherAtomsBecomeClauses) {
  CircFile file = ReadCirc("p circ 2 0\nP 1 1 0\nQ 2 0\nF 1 -2 0\n", "a.circ");
  ASSERT_TRUE(file.diagnostics.empty());
  EXPECT_THAT(MoveFacts(file.facts, file.theory), ElementsAre(-2));
  EXPECT_THAT(file.theory.clauses, ElementsAre(ElementsAre(1)));
}

}  // namespace
}  // namespace latchwork::circumscription

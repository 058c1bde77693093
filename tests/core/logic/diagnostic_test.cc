// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/diagnostic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace latchwork::logic {
namespace {

using testing::HasSubstr;

TEST(DiagnosticTest, Format_WithExcerpt_PointsAtColumn) {
  const Diagnostic diagnostic{
      {"avoid.p", 12, 5}, "role is unknown", "did you mean 'axiom'?", "fof(axim)."};
  EXPECT_EQ(Format(diagnostic),
            "avoid.p:12:5: error: role is unknown\n"
            "  12 | fof(axim).\n"
            "     |     ^\n"
            "  hint: did you mean 'axiom'?\n");
}

TEST(DiagnosticTest, Format_WholeFile_NamesFileAlone) {
  EXPECT_EQ(Format(Diagnostic{{"a.p"}, "no such file", {}, {}}), "a.p: error: no such file\n");
}

TEST(DiagnosticTest, Format_NoPlace_StartsWithError) {
  EXPECT_EQ(Format(Diagnostic{{}, "nothing", {}, {}}), "error: nothing\n");
}

TEST(DiagnosticTest, Format_ControlBytes_AreMadeSafe) {
  const Diagnostic diagnostic{
      {"a\x1b.p", 1, 1}, "bad\nmessage", {}, std::string("x\0\x1b\xff\ty", 6)};
  EXPECT_EQ(Format(diagnostic), "a?.p:1:1: error: bad?message\n  1 | x??? y\n    | ^\n");
}

TEST(DiagnosticTest, Format_CharactersBeyondAscii_CountAsOneColumn) {
  const Diagnostic diagnostic{{"a.p", 1, 4}, "m", {}, "\xc3\xa4q?"};
  EXPECT_EQ(Format(diagnostic), "a.p:1:4: error: m\n  1 | \xc3\xa4q?\n    |   ^\n");
}

TEST(DiagnosticTest, Format_LongLine_IsCutAroundCaret) {
  const Diagnostic diagnostic{
      {"a.p", 1, 501}, "m", {}, std::string(500, 'a') + "!" + std::string(500, 'b')};
  const std::string text = Format(diagnostic);
  EXPECT_LT(text.size(), 300U);
  EXPECT_THAT(text, HasSubstr("..."));
  const std::size_t bang = text.find("a!b") + 1;
  const std::size_t line = text.rfind('\n', bang);
  const std::size_t caret_line = text.find('\n', bang);
  EXPECT_EQ(bang - line, text.find('^') - caret_line);
}

TEST(DiagnosticTest, Format_ColumnBehindLine_StaysWithinLine) {
  const Diagnostic diagnostic{{"a.p", 1, 4000000000U}, "m", {}, "ab"};
  EXPECT_THAT(Format(diagnostic), HasSubstr("  1 | ab\n    |   ^\n"));
}

TEST(DiagnosticTest, Format_Several_FollowEachOther) {
  EXPECT_EQ(Format(Diagnostics{{{}, "a", {}, {}}, {{}, "b", {}, {}}}), "error: a\nerror: b\n");
}

TEST(NearestNameTest, Slip_FindsName) {
  const std::vector<std::string> names = {"axiom", "conjecture", "definition"};
  EXPECT_EQ(NearestName("axim", names), "axiom");
  EXPECT_EQ(NearestName("conjcetrue", names), "conjecture");
}

TEST(NearestNameTest, SwappedNeighbours_CountAsOneSlip) {
  EXPECT_EQ(NearestName("ofo", {"foo"}), "foo");
}

TEST(NearestNameTest, OtherWord_FindsNothing) {
  EXPECT_EQ(NearestName("banana", {"axiom", "fof"}), "");
  EXPECT_EQ(NearestName("x", {"y", "z"}), "");
  EXPECT_EQ(NearestName("", {"a", ""}), "");
}

TEST(NearestNameTest, Tie_TakesFirst) { EXPECT_EQ(NearestName("cats", {"cars", "caps"}), "cars"); }

}  // namespace
}  // namespace latchwork::logic

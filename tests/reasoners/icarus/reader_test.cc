// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/reader.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace latchwork::icarus {
namespace {

struct Read {
  Findings findings;
  SourceTree tree;
  explicit Read(std::string text) { tree = ReadForms(std::move(text), "p.icarus", findings); }

  /// "line:column code" of each finding.
  std::vector<std::string> Places() const {
    std::vector<std::string> places;
    for (const Finding& finding : findings) {
      const logic::SourcePlace& place = finding.diagnostic.place;
      places.push_back(std::to_string(place.line) + ':' + std::to_string(place.column) + ' ' +
                       std::string(Info(finding.code).name));
    }
    return places;
  }
};

using Places = std::vector<std::string>;

TEST(IcarusReaderTest, Atoms_AreToldApart) {
  const Read read("a ?x ? :means *Hard* * -12 +3 .5 1e3 1:00:04 \"a \\\" b\" 1.2.3 e5 -");
  ASSERT_TRUE(read.findings.empty());
  std::vector<FormKind> kinds;
  for (const FormId root : read.tree.roots) kinds.push_back(read.tree.kind(root));
  const std::vector<FormKind> expected = {
      FormKind::kSymbol,   FormKind::kVariable, FormKind::kVariable, FormKind::kKeyword,
      FormKind::kConstant, FormKind::kSymbol,   FormKind::kInteger,  FormKind::kInteger,
      FormKind::kReal,     FormKind::kReal,     FormKind::kSymbol,   FormKind::kString,
      FormKind::kSymbol,   FormKind::kSymbol,   FormKind::kSymbol};
  EXPECT_EQ(kinds, expected);
  EXPECT_EQ(read.tree.at(read.tree.roots[6]).integer, -12);
  EXPECT_EQ(read.tree.at(read.tree.roots[7]).integer, 3);
  EXPECT_EQ(read.tree.at(read.tree.roots[8]).real, 0.5);
  EXPECT_EQ(read.tree.Unquoted(read.tree.roots[11]), "a \" b");
}

TEST(IcarusReaderTest, Names_AreFoldedAndKeepTheirSpelling) {
  const Read read("(Fastest)");
  const FormId name = read.tree.Children(read.tree.roots.at(0)).at(0);
  EXPECT_EQ(read.tree.Folded(name), "fastest");
  EXPECT_EQ(read.tree.Text(name), "Fastest");
}

TEST(IcarusReaderTest, WrongBracket_NamesTheOpenerAndReadingGoesOn) {
  const Read read("(a (b {c d))\n(fine)\n(e {f)\n(also fine)");
  EXPECT_EQ(read.Places(), (Places{"1:11 I001", "3:6 I001"}));
  EXPECT_EQ(read.findings[0].diagnostic.message, "expected '}' to close '{' of 1:7");
  ASSERT_TRUE(read.findings[0].note.has_value());
  EXPECT_EQ(read.findings[0].note->place.column, 7U);
  EXPECT_EQ(read.tree.roots.size(), 2U);
}

TEST(IcarusReaderTest, UnclosedForm_IsReportedWhereItBegins) {
  const Read read("(a\n  (b c)\n(d)\n(e (f");
  EXPECT_EQ(read.Places(), (Places{"1:1 I001", "4:1 I001"}));
  EXPECT_EQ(read.tree.roots.size(), 1U);
}

TEST(IcarusReaderTest, BadTokens_AreAllReported) {
  const Read read("(a \"open\n b \x01 99999999999999999999 1e999)\n) }");
  EXPECT_EQ(read.Places(),
            (Places{"1:4 I002", "2:4 I002", "2:6 I002", "2:27 I002", "3:1 I001", "3:3 I001"}));
}

TEST(IcarusReaderTest, ByteOrderMark_BeginsAFileOrIsRefused) {
  EXPECT_TRUE(Read("\xef\xbb\xbf(a \"\xef\xbb\xbf\")").findings.empty());
  EXPECT_EQ(Read("\t\xef\xbb\xbf\t").Places(), (Places{"1:2 I002"}));
  EXPECT_EQ(Read("(a b\xef\xbb\xbfx)").Places(), (Places{"1:5 I002"}));
}

TEST(IcarusReaderTest, DeepNesting_IsRefusedWithoutRecursion) {
  for (const std::size_t depth : {kMaxNesting, kMaxNesting + 1, std::size_t{100'000}}) {
    const Read read(std::string(depth, '(') + std::string(depth, ')') + "\n(fine)");
    EXPECT_EQ(read.findings.empty(), depth <= kMaxNesting) << depth;
    EXPECT_EQ(read.tree.roots.size(), depth <= kMaxNesting ? 2U : 1U) << depth;
  }
}

TEST(IcarusReaderTest, SenselessInput_EndsAfterABoundedNumberOfFindings) {
  std::string lines;
  for (int i = 0; i < 20'000; ++i) lines += "(\n";
  const Read read(lines);
  EXPECT_FALSE(read.findings.empty());
  EXPECT_LE(read.findings.size(), 200U);
}

TEST(IcarusReaderTest, Comments_AreKept) {
  const Read read("; one\n(a ; two\n)");
  ASSERT_EQ(read.tree.comments.size(), 2U);
  EXPECT_EQ(read.tree.Text(read.tree.comments[1]), "; two");
  EXPECT_EQ(read.tree.comments[1].line, 2U);
}

}  // namespace
}  // namespace latchwork::icarus

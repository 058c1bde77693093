// SPDX-License-Identifier: BSD-3-Clause
//
// What is wrong with a body is said when it is loaded, with its place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "tests/reasoners/icarus/program_mind.h"
#include "tests/reasoners/icarus/test_attachments.h"

namespace latchwork::icarus::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// The diagnostics of a program in a layer that sees, goes and measures.
std::string Complaints(std::string_view program) {
  ProgramMind mind(program);
  mind.Input("seen", {sdk::ArgumentType::kSymbol, sdk::ArgumentType::kReal});
  mind.Output("go", {sdk::ArgumentType::kInteger});
  mind.attachments = {std::make_shared<Halves>()};
  return Format(mind.TryLoad());
}

TEST(IcarusLoadTest, AcceptsWhatFits) {
  EXPECT_EQ(Complaints("(top (Top)) (Top () :requires ((seen a ?x) (bind (?h ?r) {halves 7})) "
                       ":means ((Go ?h))) (Go (?n) :action ({go ?n} {store (gone ?n)}))"),
            "");
}

TEST(IcarusLoadTest, WantsATop) {
  EXPECT_THAT(Complaints("(Go () :action ({go 1}))"),
              HasSubstr("does not say which call its cycles begin with"));
  EXPECT_THAT(Complaints("(top (Og))\n(Go () :action ({go 1}))"),
              AllOf(HasSubstr("program.icarus:1:7: error: [I030] there is no skill 'Og'"),
                    HasSubstr("did you mean 'Go'?")));
  EXPECT_THAT(Complaints("(top (Go))\n(top (Go))\n(Go () :action ({go 1}))"),
              HasSubstr("2:1: error: [I030] the program has a top already"));
  EXPECT_THAT(Complaints("(top (Go 1))\n(Go () :action ({go 1}))"),
              HasSubstr("1:6: error: [I011]"));
}

TEST(IcarusLoadTest, ChecksActsAgainstTheContract) {
  EXPECT_THAT(Complaints("(top (Go))\n(Go () :action ({ogo 1}))"),
              AllOf(HasSubstr("2:17: error: [I028]"), HasSubstr("did you mean {go}?")));
  EXPECT_THAT(Complaints("(top (Go))\n(Go () :action ({go 1 2}))"),
              HasSubstr("2:17: error: [I027] {go} takes 1 argument, but is called with 2"));
  EXPECT_THAT(Complaints("(top (Go))\n(Go () :action ({go 1.5}))"),
              HasSubstr("2:21: error: [I027] {go} takes an integer here"));
  EXPECT_THAT(Complaints("(constant *N* far)\n(top (Go))\n(Go () :action ({go *N*}))"),
              HasSubstr("3:21: error: [I027]"));
}

TEST(IcarusLoadTest, ChecksCallsAgainstAttachments) {
  EXPECT_THAT(Complaints("(top (Go))\n(Go () :objective ({halves word}))"),
              HasSubstr("2:28: error: [I027] {halves} takes an integer here"));
  EXPECT_THAT(Complaints("(top (Go))\n(Go () :objective ({halve 1}))"),
              HasSubstr("did you mean {halves}?"));
}

TEST(IcarusLoadTest, ChecksWhatAttachmentsAnswer) {
  EXPECT_THAT(
      Complaints("(top (Go))\n(Go () :objective ((bind (?a ? ?) {halves 7}) {= ?a 3}))"),
      HasSubstr("2:26: error: [I027] {halves} answers a list of 2, and here is a list of 3"));
  EXPECT_THAT(Complaints("(top (Go))\n(Go () :objective ((bind (? one) {halves 7})))"),
              HasSubstr("2:29: error: [I027] {halves} answers an integer here"));
  EXPECT_THAT(
      Complaints("(top (Go))\n(Go () :objective ({< {halves 7} 3}))"),
      HasSubstr("2:23: error: [I027] {<} takes a number here, but {halves} answers a list"));
  EXPECT_THAT(
      Complaints("(top (Go))\n(Go () :objective ((bind ?x {halves {halves 7}}) (seen a ?x)))"),
      HasSubstr("2:37: error: [I027] {halves} takes an integer here, but {halves} answers"));
  EXPECT_EQ(Complaints("(top (Go))\n(Go () :objective ((bind ?x {halves 7}) {member 3 {halves 8}} "
                       "(bind (3 ?) {halves 7}) (seen a ?x)))"),
            "");
}

TEST(IcarusLoadTest, ChecksMatchesAgainstTheLatches) {
  EXPECT_THAT(Complaints("(top (Go))\n(Go () :objective ((seen ?)))"),
              HasSubstr("2:20: error: [I031] facts (seen ...) have 2 arguments, but here are 1"));
  EXPECT_THAT(Complaints("(top (Go))\n(Go () :objective ((seen 7 ?)))"),
              HasSubstr("2:26: error: [I031] facts (seen ...) have a symbol here"));
  EXPECT_THAT(Complaints("(top (Go))\n(Go () :objective ((sen ?x ?x)))"),
              AllOf(HasSubstr("2:21: error: [I032]"), HasSubstr("did you mean 'seen'?")));
}

TEST(IcarusLoadTest, ReportsFilesThatCannotBeRead) {
  ProgramMind mind("");
  std::filesystem::remove(mind.file());
  EXPECT_THAT(Format(mind.TryLoad()), HasSubstr("program.icarus: error: the file cannot be read"));
}

TEST(IcarusLoadTest, ReportsBytesThatAreNoText) {
  EXPECT_THAT(Complaints("(top (Go))\n(Go () ; caf\xe9\n :action ({go 1}))"),
              HasSubstr("2:13: error: [I002] this byte is no UTF-8"));
  for (const char* good : {"\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x99\x82"}) {
    EXPECT_EQ(Complaints("(top (Go)) (Go () :action ({go 1})) ; " + std::string(good)), "");
  }
  for (const char* bad : {"\xc0\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xe2\x82", "\x80"}) {
    EXPECT_THAT(Complaints("; " + std::string(bad)), HasSubstr("no UTF-8"));
  }
}

}  // namespace
}  // namespace latchwork::icarus::testing

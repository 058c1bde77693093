// SPDX-License-Identifier: BSD-3-Clause
//
// Programs that are deep or do not end.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "tests/reasoners/icarus/script_run.h"

namespace latchwork::icarus::testing {
namespace {

constexpr std::size_t kDeep = 10'000;

std::string Repeated(std::string_view text, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

RunOptions Depth(std::uint32_t depth) {
  RunOptions options;
  options.max_depth = depth;
  return options;
}

TEST(IcarusLimitsTest, RecursionTenThousandDeep_ComesToItsAct) {
  const ScriptRun run(
      "(Down (?n) :objective ({> ?n 10000}) :requires ((bind ?m {+ ?n 1}))\n"
      "  :means ((Down ?m)))\n"
      "(Top () :requires ((Down 1)) :means ((Go)))\n(Go () :action ({go}))",
      "(top (Top)) (cycle (repeat 2) (expect {go}))", Depth(20'000));
  EXPECT_EQ(run.clauses().back(), 3 * kDeep + 4);
}

TEST(IcarusLimitsTest, ChainOfTenThousandSkills_ComesToItsAct) {
  std::string program;
  for (std::size_t i = 0; i < kDeep; ++i) {
    program += "(s" + std::to_string(i) + " (?x) :objective ({done ?x}) :means ((s" +
               std::to_string(i + 1) + " ?x)))\n";
  }
  program += "(s10000 (?x) :action ({go ?x}))";
  const ScriptRun run(program, "(top (s0 a)) (functions done) (cycle (repeat 2) (expect {go a}))",
                      Depth(20'000));
  EXPECT_TRUE(run.faults().empty());
}

TEST(IcarusLimitsTest, NegationsAndListsAsDeepAsBracketsMayBe_AreEvaluated) {
  const std::string negations =
      "(Top () :objective (" + Repeated("(*not* ", 996) + "{never}" + Repeated(")", 996) + "))";
  const ScriptRun negated(negations, "(top (Top)) (functions never) (cycle (expect false))");
  const std::string list = Repeated("(", 990) + "a" + Repeated(")", 990);
  const ScriptRun matched("(facts (p " + list + "))\n(Top () :objective ((p " + list + ")))",
                          "(top (Top)) (cycle (expect true))");
  EXPECT_TRUE(matched.faults().empty());
}

TEST(IcarusLimitsTest, MatchesWithoutEnd_AreStoppedByTheLimitOfClauses) {
  std::string facts = "(facts";
  for (int i = 0; i < 20; ++i) facts += " (p " + std::to_string(i) + ")";
  RunOptions options;
  options.max_clauses = 10'000;
  const ScriptRun run(facts + ")\n(Top () :objective (" +
                          "(p ?a) (p ?b) (p ?c) (p ?d) (p ?e) (p ?f) (p ?g) (p ?h) (p ?i)" +
                          "(q ?a ?b ?c ?d ?e ?f ?g ?h ?i)))",
                      "(top (Top)) (cycle (expect false fault))", options);
  EXPECT_EQ(run.clauses().front(), 10'000U);
}

}  // namespace
}  // namespace latchwork::icarus::testing

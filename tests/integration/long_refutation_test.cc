// SPDX-License-Identifier: BSD-3-Clause
//
// What many instances contradict is shown in steps so small that each of them is easy to check: by
// the own checker, and by others.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

struct Step {
  std::string name;
  std::string clause;
  std::string rule;
  std::vector<std::string> parents;
};

std::vector<Step> StepsOf(const std::string& proof) {
  static const std::regex kStep(
      R"(cnf\((\w+), \w+, (.*), inference\((\w+),\[status\(thm\)\],\[([\w,]*)\]\)\)\.)");
  std::vector<Step> steps;
  std::istringstream lines(proof);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, kStep)) continue;
    Step& step = steps.emplace_back(Step{match[1], match[2], match[3], {}});
    std::istringstream parents(match[4]);
    for (std::string parent; std::getline(parents, parent, ',');) step.parents.push_back(parent);
  }
  return steps;
}

/// Each of four things in one of three places, no place with two of them.
std::string Pigeons() {
  std::string problem;
  for (int i = 1; i <= 4; ++i) {
    problem += fmt::format("cnf(some_{0}, axiom, p(t{0}, a) | p(t{0}, b) | p(t{0}, c)).\n", i);
    for (int j = i + 1; j <= 4; ++j) {
      problem += fmt::format("cnf(not_{0}_{1}, axiom, ~ p(t{0}, X) | ~ p(t{1}, X)).\n", i, j);
    }
  }
  return problem;
}

class LongRefutationTest : public ::testing::Test {
 protected:
  void SetUp() override {
    WriteText(scratch_.path() / "problem.p", Pigeons());
    proof_ =
        RunLatchwork({"prove", "--proof", "--strategy", "complete", "problem.p"}, scratch_.path())
            .out;
    steps_ = StepsOf(proof_);
  }

  test::TemporaryFolder scratch_;
  std::string proof_;
  std::vector<Step> steps_;
};

TEST_F(LongRefutationTest, Steps_HaveFewParents) {
  std::size_t resolved = 0;
  for (const Step& step : steps_) {
    EXPECT_LE(step.parents.size(), 16U) << step.name;
    resolved += step.rule == "resolution" ? 1 : 0;
  }
  EXPECT_GT(resolved, 5U) << proof_;
}

TEST_F(LongRefutationTest, OwnChecker_AcceptsIt) {
  WriteText(scratch_.path() / "proof.out", proof_);
  const auto result = RunLatchwork({"check-proof", "problem.p", "proof.out"}, scratch_.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST_F(LongRefutationTest, StepWithoutAParent_IsRejected) {
  for (const Step& step : steps_) {
    if (step.rule != "resolution") continue;
    std::string changed = proof_;
    const std::size_t place =
        changed.find(",[" + step.parents[0] + ",", changed.find("cnf(" + step.name + ","));
    ASSERT_NE(place, std::string::npos) << step.name;
    changed.erase(place + 2, step.parents[0].size() + 1);
    WriteText(scratch_.path() / "proof.out", changed);
    const auto result = RunLatchwork({"check-proof", "problem.p", "proof.out"}, scratch_.path());
    EXPECT_EQ(result.exit_code, 6) << step.name;
    EXPECT_THAT(result.err, ::testing::HasSubstr("by propositional logic")) << step.name;
  }
}

TEST_F(LongRefutationTest, Eprover_AcceptsEveryStep) {
  if (RunShell("command -v eprover", scratch_.path()).exit_code != 0) {
    GTEST_SKIP() << "eprover is not installed";
  }
  std::map<std::string, std::string> clauses;
  for (const Step& step : steps_) {
    clauses[step.name] = step.clause;
    if (step.rule != "resolution") continue;
    std::string posed = fmt::format("fof(goal, conjecture, {}).\n", step.clause);
    for (const std::string& parent : step.parents) {
      posed += fmt::format("cnf({}, axiom, {}).\n", parent, clauses.at(parent));
    }
    WriteText(scratch_.path() / "step.p", posed);
    const auto result = RunShell("eprover --auto -s --cpu-limit=5 step.p", scratch_.path());
    EXPECT_THAT(result.out, ::testing::ContainsRegex("SZS status (Theorem|ContradictoryAxioms)"))
        << posed;
  }
}

}  // namespace
}  // namespace latchwork::testing

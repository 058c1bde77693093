// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/engine/engine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "reasoners/circumscription/engine/minimal_core.h"
#include "tests/reasoners/circumscription/oracle.h"
#include "tests/reasoners/circumscription/random_theory.h"
#include "tests/reasoners/circumscription/robot_theory.h"

namespace latchwork::circumscription {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(EngineTest, RetractsADefaultWhenALatchSaysOtherwise) {
  GroundTheory theory;
  const Atom push = theory.Add({Role::kFixed, 1, "push"});
  const Atom given_up = theory.Add({Role::kMinimized, 1, "given_up"});
  const Atom object = theory.Add({Role::kMinimized, 2, "object"});
  const Atom go = theory.Add({Role::kVarying, 1, "go"});
  theory.clauses = {{-push, given_up, object}, {object, go}, {-object, -go}};
  Engine engine(theory);
  const std::vector<Literal> quiet = {-push};
  const std::vector<Literal> pushed = {push};
  const std::vector<Literal> goes = {go};
  EXPECT_TRUE(engine.SetLatches(quiet));
  EXPECT_EQ(engine.EntailsAlways(goes).verdict, Verdict::kYes);
  EXPECT_TRUE(engine.SetLatches(pushed));
  EXPECT_EQ(engine.EntailsAlways(goes).verdict, Verdict::kNo);
  EXPECT_EQ(engine.EntailsAlways(std::vector<Literal>{object}).basis, Basis::kCertificate);
}

TEST(EngineTest, Inconsistent_IsTheBasisOfEveryAnswer) {
  GroundTheory theory;
  const Atom atom = theory.Add({Role::kMinimized, 1, ""});
  theory.clauses = {{atom}, {-atom}};
  Engine engine(theory);
  engine.SetLatches({});
  const std::vector<Literal> query = {atom};
  EXPECT_EQ(engine.IsInconsistent().verdict, Verdict::kYes);
  EXPECT_EQ(engine.EntailsAlways(query).basis, Basis::kInconsistent);
  EXPECT_EQ(engine.HoldsSomewhere(query).verdict, Verdict::kNo);
}

TEST(EngineTest, NoBudget_IsUnknownAndSaysSo) {
  const RobotTheory robot(24);
  EngineOptions options;
  options.calls = 0;
  Engine engine(robot.theory, options);
  Dice dice(5);
  engine.SetLatches(robot.Latches(dice, 100));
  const Answer answer = engine.EntailsAlways(robot.queries[0]);
  EXPECT_EQ(answer.verdict, Verdict::kUnknown);
  EXPECT_EQ(answer.basis, Basis::kBudget);
}

/// A warm engine, one that often starts afresh, and a new one for each cycle.
TEST(EngineTest, WhatIsLearntChangesNoAnswer) {
  const RobotTheory robot(12);
  EngineOptions forgetful;
  forgetful.max_learnt = 3;
  Engine warm(robot.theory);
  Engine restarted(robot.theory, forgetful);
  Dice dice(17);
  for (int cycle = 0; cycle < 60; ++cycle) {
    const std::vector<Literal> latches = robot.Latches(dice, 30);
    Engine fresh(robot.theory);
    for (Engine* engine : {&warm, &restarted, &fresh}) engine->SetLatches(latches);
    for (const std::vector<Literal>& query : robot.queries) {
      const Verdict verdict = fresh.EntailsAlways(query).verdict;
      EXPECT_NE(verdict, Verdict::kUnknown);
      EXPECT_EQ(warm.EntailsAlways(query).verdict, verdict);
      EXPECT_EQ(restarted.EntailsAlways(query).verdict, verdict);
    }
  }
  EXPECT_GT(warm.statistics().learnt, 3U);
  EXPECT_GT(warm.statistics().cycles, warm.statistics().certified);
}

TEST(MinimalCoreTest, ConsistentTheory_HasNone) {
  GroundTheory theory;
  theory.Add({Role::kMinimized, 1, ""});
  theory.clauses = {{1}};
  EXPECT_FALSE(MinimalCore(theory, {}).has_value());
}

TEST(MinimalCoreTest, BodyAlone_NeedsNoLatches) {
  GroundTheory theory;
  for (int i = 0; i < 3; ++i) theory.Add({Role::kFixed, 1, ""});
  theory.clauses = {{3}, {1, 2}, {-1}, {-2}};
  const std::vector<Literal> latches = {3};
  const auto core = MinimalCore(theory, latches);
  ASSERT_TRUE(core);
  EXPECT_THAT(core->latches, IsEmpty());
  EXPECT_THAT(core->clauses, ElementsAre(1, 2, 3));
}

TEST(MinimalCoreTest, RandomTheories_CoresAreContradictoryAndMinimal) {
  Dice dice(23);
  int cores = 0;
  for (int i = 0; i < 400; ++i) {
    const GroundTheory theory = RandomTheory(dice, 8);
    const std::vector<Literal> latches = RandomLatches(dice, theory);
    const auto core = MinimalCore(theory, latches);
    ASSERT_EQ(core.has_value(), Oracle(theory, latches).models().empty());
    if (!core) continue;
    ++cores;
    GroundTheory rest = theory;
    rest.clauses.clear();
    for (const std::size_t index : core->clauses) rest.clauses.push_back(theory.clauses[index]);
    EXPECT_TRUE(Oracle(rest, core->latches).models().empty());
    for (std::size_t k = 0; k < rest.clauses.size(); ++k) {
      GroundTheory fewer = rest;
      fewer.clauses.erase(fewer.clauses.begin() + static_cast<std::ptrdiff_t>(k));
      EXPECT_FALSE(Oracle(fewer, core->latches).models().empty());
    }
  }
  EXPECT_GT(cores, 20);
}

}  // namespace
}  // namespace latchwork::circumscription

// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reasoners/circumscription/formats/lay_file.h"
#include "reasoners/circumscription/layered/conditions.h"
#include "reasoners/circumscription/layered/difference.h"
#include "reasoners/circumscription/layered/procedure.h"

namespace latchwork::circumscription {
namespace {

using testing::ElementsAre;

constexpr Literal kSlow = 3;

/// Two sectors that may push, either of which makes the layer below slow; beside them a sensor and
/// a clause that do not matter.
LayeredTheory Disjunctive() {
  return ReadLay(
             "p lay 2 8\nL 1\nP 1 1 2 3 4 0\n-1 3 0\n-2 3 0\n-4 3 0\nB 6 1\nB 7 2\n"
             "L 2\nP 1 5 6 7 8 0\n-5 6 7 0\n-8 5 0\nF 5 0\n",
             "disjunctive")
      .theory;
}

Verdict Ask(const LayeredTheory& theory, Transfer transfer, Literal literal) {
  Procedure procedure(theory, transfer);
  return procedure.Entails({&literal, 1}).verdict;
}

TEST(ProcedureTest, Disjunction_IsSeenByRefinedTransferOnly) {
  const LayeredTheory theory = Disjunctive();
  EXPECT_EQ(Ask(theory, Transfer::kSingle, kSlow), Verdict::kNo);
  EXPECT_EQ(Ask(theory, Transfer::kSingle, -kSlow), Verdict::kYes);
  EXPECT_EQ(Ask(theory, Transfer::kOpen, kSlow), Verdict::kNo);
  EXPECT_EQ(Ask(theory, Transfer::kOpen, -kSlow), Verdict::kNo);
  EXPECT_EQ(Ask(theory, Transfer::kRefined, kSlow), Verdict::kYes);
}

TEST(ProcedureTest, Outcomes_SayWhatIsHandedDown) {
  const Procedure procedure(Disjunctive(), Transfer::kRefined);
  const LayerOutcome& top = procedure.outcomes()[1];
  EXPECT_EQ(top.has_model, Verdict::kYes);
  EXPECT_THAT(top.goals, ElementsAre(2, 3));
  EXPECT_THAT(top.statuses, ElementsAre(GoalStatus::kOpen, GoalStatus::kOpen));
  EXPECT_EQ(top.states, 2U) << "one goal or the other, never both";
}

TEST(ProcedureTest, LayerWithoutModel_HandsNothingDown) {
  LayeredTheory theory = Disjunctive();
  theory.layers[1].facts.push_back(-1);
  for (const Transfer transfer : kTransfers) {
    EXPECT_EQ(Ask(theory, transfer, -kSlow), Verdict::kYes) << Name(transfer);
    EXPECT_EQ(Procedure(theory, transfer).outcomes()[1].has_model, Verdict::kNo);
  }
  const Conditions conditions = CheckConditions(theory);
  EXPECT_THAT(conditions.layers_have_models, ElementsAre(Verdict::kYes, Verdict::kNo));
  EXPECT_EQ(conditions.has_model, Verdict::kNo);
}

TEST(ConditionsTest, BridgeGivenUp_NamesWhatStandsAgainstIt) {
  LayeredTheory theory = Disjunctive();
  theory.layers[1].facts.push_back(2);
  theory.layers[0].facts.push_back(-kSlow);
  const Conditions conditions = CheckConditions(theory);
  EXPECT_EQ(conditions.consistent_with_transfers, Verdict::kNo);
  ASSERT_EQ(conditions.given_up.size(), 1U);
  EXPECT_EQ(conditions.given_up[0].layer, 0U);
  EXPECT_EQ(conditions.given_up[0].bridge, 0U);
  const BridgedTheory bridged = WithBridges(theory, 0);
  EXPECT_THAT(conditions.given_up[0].core.latches,
              ElementsAre(bridged.premises[0], -bridged.abnormal[0]));
  EXPECT_THAT(conditions.given_up[0].core.clauses,
              ElementsAre(0, bridged.first_bridge, bridged.first_fact_clause));
}

TEST(DifferenceTest, Shrink_LeavesWhatIsNeeded) {
  const CounterExample example =
      Shrink({Disjunctive(), {-kSlow}}, Transfer::kSingle, Fault::kUnsound);
  ASSERT_EQ(example.theory.layers.size(), 2U);
  EXPECT_EQ(example.theory.layers[0].bridges.size(), 1U);
  EXPECT_EQ(example.theory.layers[0].theory.clauses.size(), 1U);
  EXPECT_EQ(example.theory.layers[0].theory.atoms.size(), 2U);
  EXPECT_EQ(example.theory.layers[1].theory.clauses.size(), 1U);
  EXPECT_EQ(example.theory.layers[1].theory.atoms.size(), 3U);
  EXPECT_EQ(example.theory.layers[1].facts.size(), 1U);
  EXPECT_EQ(example.clause.size(), 1U);
}

}  // namespace
}  // namespace latchwork::circumscription

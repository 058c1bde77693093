// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/strategies/schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/tptp.h"
#include "reasoners/pttp/strategies/prover.h"

namespace latchwork::pttp {
namespace {

using ::testing::IsEmpty;

ProverProblem Problem(std::string_view text) {
  logic::SymbolTable symbols;
  return {logic::ReadTptp(text, "test.p", symbols).formulas, symbols, false};
}

TEST(ScheduleTest, Names_AreDifferentAndFound) {
  std::set<std::string_view> names;
  for (const NamedStrategy& strategy : Strategies()) {
    EXPECT_TRUE(names.insert(strategy.name).second) << strategy.name;
    EXPECT_EQ(FindStrategy(strategy.name), &strategy);
    EXPECT_FALSE(strategy.help.empty());
  }
  EXPECT_EQ(FindStrategy("no such"), nullptr);
}

TEST(ScheduleTest, StrategiesThatLeaveProofsOut_AreNotCalledComplete) {
  for (const NamedStrategy& strategy : Strategies()) {
    const bool cuts = strategy.tableau.cut != Cut::kNone ||
                      strategy.tableau.start == Start::kConjecture ||
                      strategy.saturation.relevance_depth != 0;
    EXPECT_NE(strategy.complete, cuts) << strategy.name;
  }
}

TEST(ScheduleTest, EverySchedule_NamesStrategiesAndEndsWithACompleteOneAmongThem) {
  for (const std::string_view text :
       {"fof(a, axiom, p(a)).", "fof(a, axiom, a = b). fof(c, conjecture, f(a) = f(b)).",
        "fof(a, axiom, $less(1, 2))."}) {
    bool complete = false;
    for (const Slice& slice : ScheduleFor(Problem(text))) {
      ASSERT_NE(slice.strategy, nullptr);
      EXPECT_GT(slice.share, 0);
      complete = complete || slice.strategy->complete;
    }
    EXPECT_TRUE(complete) << text;
  }
}

TEST(ScheduleTest, WithoutSaturation_TableauxProveEquationsToo) {
  logic::SymbolTable symbols;
  const auto file = logic::ReadTptp("fof(a, axiom, a = b). fof(c, conjecture, f(g(a)) = f(g(b))).",
                                    "test.p", symbols);
  ASSERT_THAT(file.diagnostics, IsEmpty());
  ProverOptions options;
  options.budget.inferences = 100'000;
  options.saturation = false;
  const ProverResult result = Prove(file.formulas, symbols, "test.p", options);
  EXPECT_EQ(result.status, Szs::kTheorem);
  EXPECT_EQ(FindStrategy(result.strategy)->method, NamedStrategy::Method::kTableau);
}

TEST(ScheduleTest, OnSeveralThreads_AProofIsFoundAndASearchWithoutOneEnds) {
  for (const unsigned threads : {2U, 64U}) {
    logic::SymbolTable symbols;
    const auto file = logic::ReadTptp(
        "cnf(a, axiom, p(X, f(X)) | q(X)). cnf(b, axiom, ~ p(X, Y) | q(X)). cnf(c, axiom, ~ q(a)).",
        "test.p", symbols);
    ProverOptions options;
    options.threads = threads;
    options.proof = true;
    const ProverResult refuted = Prove(file.formulas, symbols, "test.p", options);
    EXPECT_EQ(refuted.status, Szs::kUnsatisfiable);
    EXPECT_FALSE(refuted.proof.empty());
    const auto consistent = std::vector(file.formulas.begin(), file.formulas.end() - 1);
    EXPECT_EQ(Prove(consistent, symbols, "test.p", options).status, Szs::kSatisfiable);
    options.budget.inferences = 1;
    options.strategy = "complete";
    EXPECT_EQ(Prove(file.formulas, symbols, "test.p", options).status, Szs::kResourceOut);
  }
}

}  // namespace
}  // namespace latchwork::pttp

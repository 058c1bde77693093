// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/tptp.h"
#include "reasoners/circumscription/engine/engine.h"
#include "reasoners/circumscription/grounding/tptp_problem.h"

namespace latchwork::circumscription {
namespace {

using testing::HasSubstr;

class GroundingTest : public testing::Test {
 protected:
  TptpProblem Ground(std::string_view text, const std::vector<std::string>& minimized,
                     const GroundingLimits& limits = {}) {
    const logic::TptpFile file = logic::ReadTptp(text, "test.p", symbols_);
    EXPECT_TRUE(file.diagnostics.empty()) << Format(file.diagnostics);
    PredicateRoles roles;
    for (const logic::PredicateName& name : PredicatesOf(file.formulas)) {
      for (const std::string& wanted : minimized) {
        if (ToString(name) == wanted) roles.minimized[name] = 1;
      }
    }
    return GroundTptp(file.formulas, roles, symbols_, limits);
  }

  std::string Answers(std::string_view text, const std::vector<std::string>& minimized) {
    const TptpProblem problem = Ground(text, minimized);
    EXPECT_TRUE(problem.diagnostics.empty()) << Format(problem.diagnostics);
    Engine engine(problem.theory);
    engine.SetLatches({});
    std::string answers;
    for (const Query& query : problem.queries) {
      answers += std::string(Name(engine.EntailsAlways(query.literals).verdict)) + " ";
    }
    return answers;
  }

  logic::SymbolTable symbols_;
};

TEST_F(GroundingTest, Closure_IsTheLeastModel) {
  EXPECT_EQ(Answers("cnf(ab, axiom, edge(a,b)). cnf(bc, axiom, edge(b,c)). cnf(d, axiom, node(d))."
                    "fof(one, axiom, ![X,Y]: (edge(X,Y) => path(X,Y)))."
                    "fof(two, axiom, ![X,Y,Z]: ((path(X,Y) & edge(Y,Z)) => path(X,Z)))."
                    "fof(q1, conjecture, path(a,c)). fof(q2, conjecture, ~path(c,a))."
                    "fof(q3, conjecture, ![X]: ~path(X,d)). fof(q4, conjecture, path(a,d)).",
                    {"edge/2", "path/2"}),
            "yes yes yes no ");
}

TEST_F(GroundingTest, Existentials_AreDisjunctionsOverTheDomain) {
  EXPECT_EQ(
      Answers("fof(some, axiom, ?[X]: broken(X)). cnf(a, axiom, part(a)). "
              "cnf(b, axiom, part(b)). fof(q1, conjecture, broken(a) | broken(b))."
              "fof(q2, conjecture, ~(broken(a) & broken(b))). fof(q3, conjecture, broken(a)).",
              {"broken/1"}),
      "yes yes no ");
}

TEST_F(GroundingTest, Equivalences_ExpandBothWays) {
  EXPECT_EQ(Answers("fof(all, axiom, fine <=> ![X]: ok(X)). fof(any, axiom, odd <=> ?[X]: ~ok(X))."
                    "cnf(a, axiom, ok(a)). cnf(b, axiom, ~ok(b))."
                    "fof(q1, conjecture, odd). fof(q2, conjecture, fine).",
                    {}),
            "yes no ");
}

TEST_F(GroundingTest, WithoutConstants_SomethingExists) {
  EXPECT_EQ(Answers("fof(a, axiom, q). fof(q1, conjecture, ?[X]: p(X))."
                    "fof(q2, conjecture, ![X]: p(X)). fof(q3, conjecture, ?[X]: (p(X) | ~p(X)))."
                    "fof(q4, conjecture, ![X]: ~p(X)).",
                    {}),
            "no no yes no ");
  EXPECT_EQ(Answers("fof(a, axiom, ![X]: p(X)). fof(q1, conjecture, ?[X]: p(X)).", {}), "yes ");
}

TEST_F(GroundingTest, WithoutConstants_ContradictionsAreSeen) {
  const TptpProblem problem =
      Ground("fof(a, axiom, ?[X]: p(X)). fof(b, axiom, ![X]: ~p(X)).", {"p/1"});
  Engine engine(problem.theory);
  engine.SetLatches({});
  EXPECT_EQ(engine.IsInconsistent().verdict, Verdict::kYes);
}

TEST_F(GroundingTest, ConstantsOfAQuery_ExistForTheOthers) {
  EXPECT_EQ(Answers("fof(a, axiom, p(a)). fof(q1, conjecture, ![X]: p(X)).", {"p/1"}), "yes ");
  EXPECT_EQ(Answers("fof(a, axiom, p(a)). fof(q1, conjecture, ![X]: p(X))."
                    "fof(q2, conjecture, ~p(b)).",
                    {"p/1"}),
            "no yes ");
}

TEST_F(GroundingTest, ConstantsAreDifferent) {
  EXPECT_EQ(Answers("fof(one, axiom, ![X]: (X != a => far(X))). cnf(b, axiom, seen(b))."
                    "fof(q1, conjecture, far(b)). fof(q2, conjecture, far(a)).",
                    {}),
            "yes no ");
}

TEST_F(GroundingTest, InstancesThatCannotMatterAreLeftOut) {
  const TptpProblem problem = Ground(
      "cnf(a, axiom, edge(a,b)). cnf(c, axiom, node(c))."
      "fof(r, axiom, ![X,Y]: (edge(X,Y) => near(X,Y))).",
      {"edge/2"});
  EXPECT_EQ(problem.theory.clauses.size(), 3U);
  EXPECT_EQ(problem.theory.atoms.size(), 3U);
}

TEST_F(GroundingTest, OutsideTheFragment_EveryReasonIsGiven) {
  const TptpProblem problem =
      Ground("fof(f, axiom, p(s(zero))).\nfof(g, axiom, ![X]: ($less(X,3) => p(X))).\n", {"p/1"});
  ASSERT_EQ(problem.diagnostics.size(), 2U);
  EXPECT_THAT(problem.diagnostics[0].message, HasSubstr("'s/1' is a function"));
  EXPECT_THAT(problem.diagnostics[1].message, HasSubstr("'$less/2' is arithmetic"));
  EXPECT_EQ(problem.diagnostics[1].place.line, 2U);
}

TEST_F(GroundingTest, TooLarge_IsRefused) {
  GroundingLimits limits;
  limits.steps = 50;
  const TptpProblem problem = Ground(
      "fof(f, axiom, ![X,Y,Z,U]: p(X,Y,Z,U)). cnf(a, axiom, q(a)). cnf(b, axiom, q(b))."
      "cnf(c, axiom, q(c)).",
      {}, limits);
  ASSERT_EQ(problem.diagnostics.size(), 1U);
  EXPECT_THAT(problem.diagnostics[0].message, HasSubstr("more than 50 steps"));
}

}  // namespace
}  // namespace latchwork::circumscription

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/explanation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "latchwork/logic/tptp.h"
#include "reasoners/pttp/proofs/failure_explanation.h"
#include "reasoners/pttp/strategies/prover.h"

namespace latchwork::pttp {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

struct Limits {
  std::string_view strategy = "complete";
  std::uint64_t inferences = 20'000;
  std::uint32_t depth = 1000;
};

std::string Text(const Explanation& lines) {
  std::string text;
  for (const ExplanationLine& line : lines) {
    text += std::string(std::size_t{2} * line.depth, ' ') + line.text + "\n";
  }
  return text;
}

/// What is said about a problem, proved or not.
std::string Why(std::string_view problem, const Limits& limits = {}) {
  logic::SymbolTable symbols;
  const auto file = logic::ReadTptp(problem, "test", symbols);
  EXPECT_THAT(file.diagnostics, IsEmpty()) << Format(file.diagnostics);
  ProverOptions options;
  options.budget.inferences = limits.inferences;
  options.budget.depth = limits.depth;
  options.strategy = limits.strategy;
  options.proof = true;
  options.explain = true;
  const ProverResult result = Prove(file.formulas, symbols, "test", options);
  const bool proved = result.status == Szs::kTheorem || result.status == Szs::kUnsatisfiable;
  EXPECT_EQ(proved, !result.explanation.empty());
  return Text(proved ? result.explanation : ExplainFailure(result, options, symbols));
}

std::string Graph(std::string_view goal) {
  return "fof(fact1, axiom, edge(a, b)). fof(fact2, axiom, edge(b, d)). "
         "fof(fact12, axiom, edge(d, e)). "
         "fof(base, axiom, ![X, Y] : (edge(X, Y) => reachable(X, Y))). "
         "fof(step, axiom, ![X, Y, Z] : ((edge(X, Y) & reachable(Y, Z)) => reachable(X, Z))). "
         "fof(goal, conjecture, " +
         std::string(goal) + ").";
}

TEST(ExplainProofTest, Chain_IsATreeFromTheGoal) {
  EXPECT_EQ(Why(Graph("?[X] : reachable(b, X)")),
            "goal holds with X = d, since\n"
            "  reachable(b, d): by base with X = b, Y = d, since\n"
            "    edge(b, d): by fact2\n"
            "Formulas used: base, fact2, goal.\n");
}

TEST(ExplainProofTest, CasesAndRepetition_AreFolded) {
  EXPECT_EQ(Why("fof(a, axiom, (p | q)). fof(b, axiom, (p => r)). fof(d, axiom, (q => r))."
                "fof(e, axiom, (r => s)). fof(c, conjecture, (r & s))."),
            "c holds, since\n"
            "  r: by b, since\n"
            "    p: by a, since\n"
            "      ~ q: by d, since\n"
            "        ~ r: by the assumption above (else the goal there holds already)\n"
            "  s: by e, since\n"
            "    r: as above\n"
            "Formulas used: a, b, c, d, e.\n");
}

TEST(ExplainProofTest, NameThatWasMadeUp_IsExplained) {
  const std::string text =
      Why("fof(a, axiom, ?[X] : p(X)). fof(b, axiom, ![X] : (p(X) => q(X)))."
          "fof(c, conjecture, ?[X] : q(X)).");
  EXPECT_THAT(text, HasSubstr("is a name for what a speaks of without naming it"));
}

TEST(ExplainProofTest, AssumptionOfTheConjecture_IsItsNegation) {
  EXPECT_THAT(Why("fof(b, axiom, (p => q)). fof(c, conjecture, (p => q))."),
              HasSubstr("p: by the negation of c\n"));
}

TEST(ExplainProofTest, ComputedLiteral_IsByArithmetic) {
  EXPECT_THAT(Why("tff(a, axiom, ![X : $int] : ($less(X, 3) => p(X))). tff(c, conjecture, p(2)).",
                  {.strategy = "engine"}),
              HasSubstr("$less(2, 3): by arithmetic\n"));
}

TEST(ExplainProofTest, ClausesAlone_BeginWithTheOneThatIsContradicted) {
  EXPECT_THAT(Why("cnf(a, axiom, p(X)). cnf(b, axiom, ~ p(a))."),
              StartsWith("b contradicts the other formulas, since\n  p(a): by a with X = a\n"));
}

TEST(ExplainProofTest, Equations_NameTheAxiomOfEquality) {
  EXPECT_THAT(Why("fof(a, axiom, a = b). fof(c, conjecture, b = a)."),
              HasSubstr("b = a: by symmetry of equality"));
}

TEST(ExplainProofTest, Saturation_IsAChainOfSteps) {
  const std::string text = Why(Graph("reachable(b, d)"), {.strategy = "saturate"});
  EXPECT_THAT(text, StartsWith("A contradiction follows, step by step:\n  1. "));
  EXPECT_THAT(text, HasSubstr("from fact2\n"));
  EXPECT_THAT(text, HasSubstr("from the negation of goal\n"));
  EXPECT_THAT(text, HasSubstr(". contradiction, from "));
}

TEST(ExplainProofTest, SameProblem_GivesTheSameLines) {
  EXPECT_EQ(Why(Graph("reachable(a, e)")), Why(Graph("reachable(a, e)")));
}

TEST(ExplainFailureTest, FactThatIsMissing_HasANearestOne) {
  const std::string text = Why(Graph("reachable(a, c)"));
  EXPECT_THAT(text, StartsWith("Everything was searched (strategy complete): "));
  EXPECT_THAT(text, HasSubstr("  no clause concludes edge(d, c): nearest edge(d, e) of fact12: "
                              "argument 2 is e, wanted c, which no conclusion has there\n"
                              "    needed for reachable(d, c), for reachable(b, c), "));
}

TEST(ExplainFailureTest, ArgumentsThatAreRightOneByOne_AreWrongTogether) {
  const std::string text =
      Why("fof(f, axiom, edge(a, b)). fof(g, axiom, edge(d, c)). fof(c, conjecture, edge(a, c)).");
  EXPECT_THAT(text, HasSubstr("nearest edge(a, b) of f: argument 2 is b, wanted c\n"));
}

TEST(ExplainFailureTest, PredicateWithoutConclusion_MayBeATypingSlip) {
  const std::string text =
      Why("fof(f, axiom, color(car, red)). fof(r, axiom, ![X] : (colour(X, red) => nice(X)))."
          "fof(c, conjecture, nice(car)).");
  EXPECT_THAT(text,
              HasSubstr("No formula concludes colour/2, which r needs (did you mean color?)"));
}

TEST(ExplainFailureTest, PredicateOfOtherArity_IsNamed) {
  EXPECT_THAT(Why("fof(f, axiom, fast(car, very)). fof(c, conjecture, fast(car))."),
              HasSubstr("No formula concludes fast/1, which c needs (f concludes fast/2)."));
}

TEST(ExplainFailureTest, NameOfTheConjectureAlone_MayBeATypingSlip) {
  EXPECT_THAT(Why("fof(f, axiom, fast(lorry)). fof(c, conjecture, fast(lorrry))."),
              HasSubstr("lorrry occurs in c alone (did you mean lorry?)."));
}

TEST(ExplainFailureTest, Conjunction_HasEachGoalThatFails) {
  const std::string text =
      Why("fof(f, axiom, p(a)). fof(g, axiom, q(b)). fof(h, axiom, r(a))."
          "fof(c, conjecture, (p(b) & q(a) & r(a))).");
  EXPECT_THAT(text, HasSubstr("no clause concludes p(b): nearest p(a) of f"));
  EXPECT_THAT(text, HasSubstr("no clause concludes q(a): nearest q(b) of g"));
  EXPECT_THAT(text, Not(HasSubstr("concludes r(a)")));
}

TEST(ExplainFailureTest, ComparisonThatIsFalse_IsShown) {
  const std::string text =
      Why("tff(a, axiom, ![X : $int] : ((age(X) & $less(18, X)) => adult)). tff(b, axiom, age(17))."
          "tff(c, conjecture, adult).",
          {.strategy = "engine"});
  EXPECT_THAT(text, HasSubstr("nothing makes true $less(18, 17)\n    needed for adult\n"));
}

constexpr std::string_view kNumbers =
    "fof(z, axiom, nat(zero)). fof(s, axiom, ![X] : (nat(X) => nat(s(X))))."
    "fof(c, conjecture, nat(s(s(s(s(s(s(zero)))))))).";

TEST(ExplainFailureTest, ConclusionThatIsComputed_MatchesWhatItComesTo) {
  const std::string text =
      Why("tff(a, axiom, level(0)). tff(d, axiom, next(1)). tff(e, axiom, ok(0))."
          "tff(b, axiom, ![X : $int] : ((level(X) & ok(X) & next($sum(X, 1))) => "
          "level($sum(X, 1)))). tff(c, conjecture, level(2)).",
          {.strategy = "engine"});
  EXPECT_THAT(text,
              HasSubstr("  no clause concludes ok(1): nearest ok(0) of e: argument 1 is 0, "
                        "wanted 1, which no conclusion has there\n    needed for level(2)\n"));
  EXPECT_THAT(text, Not(HasSubstr("concludes level")));
  EXPECT_THAT(text, Not(HasSubstr("concludes next(1)")));
}

TEST(ExplainFailureTest, BoundOnInferences_IsNamed) {
  const std::string text = Why(kNumbers, {.inferences = 2});
  EXPECT_THAT(text, HasSubstr("its bound of 2 inferences (--inferences)"));
  EXPECT_THAT(text, HasSubstr("There is a proof: a short search with other limits finds it."));
}

TEST(ExplainFailureTest, BoundOnDepth_IsNamed) {
  EXPECT_THAT(Why(kNumbers, {.depth = 2}), HasSubstr("its bound on depth, 2 (--depth)"));
}

TEST(ExplainFailureTest, EndlessSearch_IsCutOff) {
  const std::string text =
      Why("fof(s, axiom, ![X] : (p(f(X)) => p(X))). fof(c, conjecture, p(a)).", {.depth = 30});
  EXPECT_THAT(text, HasSubstr("There are more attempts than were looked at here."));
}

TEST(ExplainFailureTest, NothingToContradict_IsSaid) {
  EXPECT_THAT(Why("fof(a, axiom, p)."), HasSubstr("There is no conjecture"));
}

}  // namespace
}  // namespace latchwork::pttp

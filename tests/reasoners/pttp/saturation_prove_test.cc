// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/reasoners/pttp/saturation_fixture.h"

namespace latchwork::pttp::saturation {
namespace {

std::string Cnf(std::initializer_list<const char*> clauses) {
  std::string text;
  for (const char* clause : clauses) {
    text += "cnf(c, axiom, " + std::string(clause) + ").\n";
  }
  return text;
}

Status StatusOf(std::initializer_list<const char*> clauses, const Options& options = {}) {
  return Attempt(Cnf(clauses), options).outcome.status;
}

/// With this, `p(a)` and `p(f(X)) | ~ p(X)` go on for ever.
Options Endless() {
  Options options;
  options.selection = Selection::kLargest;
  return options;
}

bool Uses(const Outcome& outcome, std::string_view rule) {
  return std::ranges::any_of(outcome.proof, [&](const Step& step) { return step.rule == rule; });
}

TEST(SaturateTest, NoClauses_IsSaturated) { EXPECT_EQ(StatusOf({}), Status::kSaturated); }

TEST(SaturateTest, Resolution_NonUnits_RefutesByResolution) {
  const Attempt run(Cnf({"p(X, a) | q(X)", "~ p(b, Y) | r(Y)", "~ q(b)", "~ r(a)"}));
  EXPECT_EQ(run.outcome.status, Status::kRefuted);
  EXPECT_TRUE(Uses(run.outcome, "resolution"));
}

TEST(SaturateTest, Factoring_TwoVariables_IsNeeded) {
  const Attempt run(Cnf({"p(X) | p(Y)", "~ p(X) | ~ p(Y)"}));
  EXPECT_EQ(run.outcome.status, Status::kRefuted);
}

TEST(SaturateTest, Superposition_Transitivity_RefutesEquations) {
  EXPECT_EQ(StatusOf({"a = b", "b = c", "a != c"}), Status::kRefuted);
  EXPECT_EQ(StatusOf({"a = b", "b = c", "a != d"}), Status::kSaturated);
}

TEST(SaturateTest, Superposition_NonUnitEquations_Refutes) {
  const Attempt run(Cnf({"f(a) = b | r", "~ r | p(b)", "p(f(a)) | ~ r", "~ p(f(a)) | f(a) != b",
                         "p(b) | r", "~ p(b) | ~ r"}));
  EXPECT_EQ(run.outcome.status, Status::kRefuted);
}

TEST(SaturateTest, EqualityResolution_UnifiableSides_Refutes) {
  EXPECT_EQ(StatusOf({"g(X, a) != g(b, Y)"}), Status::kRefuted);
}

TEST(SaturateTest, EqualityFactoring_ThreeElements_Refutes) {
  // Every element is a or b, yet three differ.
  const Attempt run(Cnf({"X = a | X = b", "c != d", "d != e", "c != e"}));
  EXPECT_EQ(run.outcome.status, Status::kRefuted);
}

TEST(SaturateTest, GroupTheory_LeftInverse_IsRightInverse) {
  const std::string group =
      "cnf(left_identity, axiom, m(e, X) = X).\n"
      "cnf(left_inverse, axiom, m(i(X), X) = e).\n"
      "cnf(associativity, axiom, m(m(X, Y), Z) = m(X, m(Y, Z))).\n";
  const Attempt proof(group + "cnf(goal, negated_conjecture, m(a, i(a)) != e).\n");
  EXPECT_EQ(proof.outcome.status, Status::kRefuted);
  Options options;
  options.weightless_unary = true;
  const Attempt commutes(group + "cnf(goal, negated_conjecture, m(a, b) != m(b, a)).\n", options);
  EXPECT_EQ(commutes.outcome.status, Status::kSaturated);
}

TEST(SaturateTest, EverySelectionAndPrecedence_DecidesBothWays) {
  for (const auto selection : {Selection::kMaximal, Selection::kLargest, Selection::kSmallest,
                               Selection::kUnlessUnique, Selection::kFirst}) {
    for (const auto precedence :
         {Precedence::kRareGreater, Precedence::kFrequentGreater, Precedence::kArity}) {
      Options options;
      options.selection = selection;
      options.precedence = precedence;
      const auto with = [&](const char* last) {
        return StatusOf({"p(a)", "~ p(X) | p(f(f(X)))", "f(f(f(X))) = X", last}, options);
      };
      EXPECT_EQ(with("~ p(f(a))"), Status::kRefuted);
      EXPECT_EQ(with("~ p(b)"), Status::kSaturated);
    }
  }
}

TEST(SaturateTest, Numbers_Different_AreUnequal) {
  EXPECT_EQ(StatusOf({"a = 1", "a = 2"}), Status::kRefuted);
  EXPECT_EQ(StatusOf({"a = 1.5", "a = 2.5"}), Status::kRefuted);
  EXPECT_EQ(StatusOf({"a = \"one\"", "a = \"two\""}), Status::kRefuted);
  EXPECT_EQ(StatusOf({"a = \"one\"", "a = 1"}), Status::kRefuted);
}

TEST(SaturateTest, FixedMeaning_NoRefutation_IsNotCalledSaturated) {
  EXPECT_EQ(StatusOf({"a = 1"}), Status::kGaveUp);
  EXPECT_EQ(StatusOf({"p(\"one\")"}), Status::kGaveUp);
  EXPECT_EQ(StatusOf({"$less(a, b)"}), Status::kGaveUp);
}

TEST(SaturateTest, VariableEquation_AtomsAreNoTerms) {
  // One element only; atoms stay what they are.
  EXPECT_EQ(StatusOf({"X = a", "p(b)", "~ q(b)"}), Status::kSaturated);
  EXPECT_EQ(StatusOf({"X = a", "p(b)", "~ p(c)"}), Status::kRefuted);
}

TEST(SaturateTest, Relevance_LeavesOutAxioms_IsNotCalledSaturated) {
  const std::string text =
      "cnf(a, axiom, p(a)).\ncnf(b, axiom, ~ p(X) | q(X)).\ncnf(c, axiom, r(c)).\n";
  Options options;
  options.relevance_depth = 3;
  EXPECT_EQ(Attempt(text + "cnf(g, negated_conjecture, ~ q(a)).\n", options).outcome.status,
            Status::kRefuted);
  EXPECT_EQ(Attempt(text + "cnf(g, negated_conjecture, ~ q(b)).\n", options).outcome.status,
            Status::kGaveUp);
}

TEST(SaturateTest, SetOfSupport_NoRefutation_IsNotCalledSaturated) {
  Options options;
  options.set_of_support = true;
  EXPECT_EQ(Attempt("cnf(a, axiom, p(a)).\ncnf(g, negated_conjecture, ~ p(b)).\n", options)
                .outcome.status,
            Status::kGaveUp);
}

TEST(SaturateTest, Conclusions_OverMaximalSize_AreNotCalledSaturated) {
  Options options = Endless();
  options.max_size = 20;
  EXPECT_EQ(StatusOf({"p(a)", "p(f(X)) | ~ p(X)"}, options), Status::kGaveUp);
}

TEST(SaturateTest, Inferences_Limited_Ends) {
  Options options = Endless();
  options.max_inferences = 100;
  const Attempt run(Cnf({"p(a)", "p(f(X)) | ~ p(X)"}), options);
  EXPECT_EQ(run.outcome.status, Status::kInferences);
  EXPECT_EQ(run.outcome.statistics.inferences, 100U);
}

TEST(SaturateTest, Memory_Limited_Ends) {
  const Attempt run(Cnf({"p(a)", "p(f(X)) | ~ p(X)", "~ p(X) | p(g(X, X))"}), Endless(), 4U << 20U);
  EXPECT_EQ(run.outcome.status, Status::kMemory);
}

TEST(SaturateTest, Stop_Called_Ends) {
  logic::SymbolTable symbols;
  const auto input = logic::ReadTptp(Cnf({"p(a)", "p(f(X)) | ~ p(X)"}), "test", symbols);
  const auto clauses = logic::Clausify(input.formulas, symbols);
  int calls = 0;
  const std::function<bool()> stop = [&] { return ++calls > 20; };
  const auto outcome = Saturate({clauses, symbols}, Endless(), {std::size_t{1} << 30U, stop});
  EXPECT_EQ(outcome.status, Status::kStopped);
  EXPECT_EQ(calls, 21);
}

TEST(SaturateTest, DeepTerms_DoNotOverflow) {
  constexpr std::size_t kDepth = 100'000;
  std::string deep;
  for (std::size_t i = 0; i < kDepth; ++i) deep += "f(";
  const std::string close(kDepth, ')');
  const Attempt run("cnf(a, axiom, p(" + deep + "X" + close + ") | q(X)).\ncnf(b, axiom, ~ p(" +
                    deep + "a" + close + ")).\ncnf(c, axiom, ~ q(c)).\ncnf(d, axiom, a = c).\n");
  EXPECT_EQ(run.outcome.status, Status::kRefuted);
}

TEST(SaturateTest, SameInput_GivesSameProof) {
  const std::string text =
      Cnf({"m(e, X) = X", "m(i(X), X) = e", "m(m(X, Y), Z) = m(X, m(Y, Z))", "m(a, i(a)) != e"});
  const Attempt first(text);
  const Attempt second(text);
  ASSERT_EQ(first.outcome.proof.size(), second.outcome.proof.size());
  EXPECT_EQ(first.outcome.statistics.inferences, second.outcome.statistics.inferences);
  for (std::size_t i = 0; i < first.outcome.proof.size(); ++i) {
    EXPECT_EQ(ToString(first.outcome.proof[i].clause), ToString(second.outcome.proof[i].clause));
    EXPECT_EQ(first.outcome.proof[i].parents, second.outcome.proof[i].parents);
  }
}

}  // namespace
}  // namespace latchwork::pttp::saturation

// SPDX-License-Identifier: BSD-3-Clause
//
// A proof that the command prints is accepted by the command that checks it; what was changed in it
// is found.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <ostream>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int kVerified = 0;
constexpr int kUnchecked = 1;
constexpr int kUnreadable = 3;
constexpr int kRejected = 6;

constexpr std::string_view kProblem = R"(
fof(a1, axiom, ![X] : (p(X) => ?[Y] : (q(X, Y) & (r(Y) <=> s(X))))).
fof(a2, axiom, ![X, Y] : (q(X, Y) => (r(Y) | t(X)))).
fof(a3, axiom, ![X] : (t(X) => s(X))).
cnf(a4, axiom, p(X) | u(X, a)).
fof(a5, axiom, ![X] : ~ ?[Y] : u(X, Y)).
fof(c1, conjecture, ?[X] : s(f(X))).
fof(c2, conjecture, ?[X, Y] : q(X, Y)).
)";

class CheckProofTest : public ::testing::Test {
 protected:
  std::string Prove(std::string_view problem) {
    WriteText(scratch_.path() / "problem.p", std::string(problem));
    const CommandResult result = RunLatchwork({"prove", "--proof", "problem.p"}, scratch_.path());
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
    return result.out;
  }

  CommandResult Check(const std::string& proof, std::vector<std::string> options = {}) {
    WriteText(scratch_.path() / "proof.out", proof);
    std::vector<std::string> arguments{"check-proof", "problem.p", "proof.out"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunLatchwork(arguments, scratch_.path());
  }

  TemporaryFolder scratch_;
};

/// The text with the first `from` replaced.
std::string Replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << "no '" << from << "' in\n" << text;
  return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

/// The text without the line that begins so.
std::string WithoutLine(const std::string& text, std::string_view beginning) {
  const std::size_t place = text.find(beginning);
  EXPECT_NE(place, std::string::npos) << beginning;
  std::string shorter = text;
  return shorter.erase(place, text.find('\n', place) - place + 1);
}

TEST_F(CheckProofTest, ProofsOfTheCommand_AreVerified) {
  constexpr std::array<std::string_view, 6> kProblems = {
      kProblem,
      "cnf(a, axiom, p(X) | q). cnf(b, axiom, ~ p(f(Y))). cnf(c, axiom, ~ q).",
      "fof(a, axiom, f(a) = b). fof(b, axiom, p(f(a))). fof(c, conjecture, p(b)).",
      "fof(c, conjecture, ?[X] : ![Y] : (d(X) => d(Y))).",
      "fof(c, conjecture, (((p <=> q) <=> r) <=> (p <=> (q <=> r)))).",
      "fof(c, conjecture, ~ ?[X] : ![Y] : (f(Y, X) <=> ~ f(Y, Y))).",
  };
  for (const std::string_view problem : kProblems) {
    const std::string proof = Prove(problem);
    const CommandResult result = Check(proof);
    EXPECT_EQ(result.exit_code, kVerified) << proof << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("verified: "));
  }
}

TEST_F(CheckProofTest, ClausesOfLargeFormulas_NeedOnlyTheirOwnDefinitions) {
  std::string pairs = "(X = c0 & Y = c1)";
  for (int i = 1; i < 60; ++i) pairs += fmt::format(" | (X = c{} & Y = c{})", i, i + 1);
  const std::string proof =
      Prove(fmt::format("fof(edges, axiom, ![X, Y] : (edge(X, Y) <=> ({}))).\n"
                        "fof(goal, conjecture, edge(c40, c41)).\n",
                        pairs));
  EXPECT_THAT(proof, HasSubstr("[edges,definition_1]"));
  EXPECT_THAT(proof, Not(HasSubstr("definition_2")));
  const CommandResult result = Check(proof);
  EXPECT_EQ(result.exit_code, kVerified) << result.err;
}

TEST_F(CheckProofTest, DefinitionsOfLargeFormulas_AreVerified) {
  std::string pairs;
  std::string firsts;
  for (const char* const i : {"1", "2", "3", "4", "5", "6"}) {
    const std::string separator = pairs.empty() ? "" : " | ";
    pairs += separator + "(a" + i + "(X) & ?[Y] : b" + i + "(X, Y))";
    firsts += separator + "a" + i + "(X)";
  }
  const std::string proof =
      Prove("fof(a, axiom, ![X] : (" + pairs + ")). fof(c, conjecture, ![X] : (" + firsts + ")).");
  EXPECT_THAT(proof, HasSubstr("introduced(definition"));
  const CommandResult result = Check(proof);
  EXPECT_EQ(result.exit_code, kVerified) << result.err;
}

TEST_F(CheckProofTest, ManyDefinitions_AreBroughtInAFewAtATime) {
  std::string problem;
  std::string choices;
  for (int i = 0; i < 30; ++i) {
    problem += fmt::format("fof(a{0}, axiom, p{0} | q{0}).\n", i);
    choices += fmt::format("{1}(p{0} | (q{0} & ~ r{0}) | (q{0} & r{0}))", i, i == 0 ? "" : " & ");
  }
  const std::string proof = Prove(problem + "fof(c, conjecture, " + choices + ").\n");
  static const std::regex kNormalize(R"(inference\(normalize,\[status\(thm\)\],\[(.*)\]\))");
  std::size_t most = 0;
  for (std::sregex_iterator each(proof.begin(), proof.end(), kNormalize), end; each != end;
       ++each) {
    const std::string parents = (*each)[1];
    most = std::max(most,
                    1 + static_cast<std::size_t>(std::count(parents.begin(), parents.end(), ',')));
  }
  EXPECT_GT(most, 2U) << proof;
  EXPECT_LE(most, 9U) << proof;
  const CommandResult result = Check(proof);
  EXPECT_EQ(result.exit_code, kVerified) << result.err;
  EXPECT_EQ(Check(Replaced(proof, ",definition_7", "")).exit_code, kRejected);
}

TEST_F(CheckProofTest, ConjunctsOfAnAxiom_AreShownOneByOne) {
  const std::string proof = Prove(
      "fof(a, axiom, ![X] : (p(X) <=> ?[Y] : (q(X, Y) & r(Y))))."
      "fof(b, axiom, ![X] : (q(X, a) & ![Z] : (q(Z, b) & p(b))))."
      "fof(c, conjecture, ?[Y] : (q(b, Y) & r(Y))).");
  EXPECT_THAT(proof, HasSubstr("! [X] : (~ p(X) | ? [Y] : (q(X, Y) & r(Y))), inference(normalize"));
  const CommandResult result = Check(proof);
  EXPECT_EQ(result.exit_code, kVerified) << result.err;
}

/// Quantifiers within quantifiers, so many, of alternating variables; `x` is free.
std::string NestedFormula(int depth, const std::string& x, const std::string& y) {
  if (depth == 0) return fmt::format("p({})", x);
  return fmt::format(
      "! [{1}] : (~ r({0}, {1}) | ~ ({2} & (q{3}({1}) | ~ ! [{0}] : (~ r({1}, {0}) | p({0})))))", x,
      y, NestedFormula(depth - 1, y, x), depth);
}

TEST_F(CheckProofTest, DeepNormalForm_IsShownPartByPart) {
  const std::string formula = NestedFormula(5, "X", "Y");
  const std::string proof =
      Prove(fmt::format("fof(c, conjecture, ! [X] : ({0} => {0})).", formula));
  const CommandResult result = Check(proof);
  EXPECT_EQ(result.exit_code, kVerified) << result.err;
  const std::string last_lemma = "~ ! [X] : ~ part_1(X) => ? [X] : part_1(X)";
  const std::string unfolded = "! [X] : (~ part_1(X) | ! [Y] : (~ r(X, Y) | def_1(Y) | (~ q5(Y) & ";
  for (const auto& [right, wrong] :
       {std::pair{last_lemma, std::string("~ ! [X] : ~ part_1(X) => ! [X] : part_1(X)")},
        {unfolded, Replaced(unfolded, "(~ q5(Y) &", "(~ q4(Y) &")},
        {unfolded, Replaced(unfolded, "def_1(Y)", "def_1(X)")},
        {unfolded, Replaced(unfolded, "~ part_1(X) | ", "")}}) {
    const CommandResult changed = Check(Replaced(proof, right, wrong));
    EXPECT_EQ(changed.exit_code, kRejected) << wrong;
    EXPECT_THAT(changed.err, HasSubstr("it is no normal form of its parent")) << wrong;
  }
}

TEST_F(CheckProofTest, ConjunctionBelowAQuantifier_IsMovedOut) {
  const std::string proof = Prove(
      "fof(a, axiom, ![E, F, T] : (rel(E, F, T) <=> ?[H] : (E = tap & F = level(H))))."
      "fof(b, axiom, rel(c, d, e)). fof(c, conjecture, c = tap).");
  EXPECT_THAT(proof, HasSubstr("(~ rel(E, F, T) | (E = tap & ? [H] : F = level(H)))"));
  const CommandResult result = Check(proof);
  EXPECT_EQ(result.exit_code, kVerified) << result.err;
}

struct Change {
  std::string name;
  std::string from;
  std::string to;
  std::string complaint;
};

void PrintTo(const Change& change, std::ostream* stream) { *stream << change.name; }

class ChangedProofTest : public CheckProofTest, public ::testing::WithParamInterface<Change> {};

TEST_P(ChangedProofTest, IsRejected) {
  const Change& change = GetParam();
  const CommandResult result = Check(Replaced(Prove(kProblem), change.from, change.to));
  EXPECT_EQ(result.exit_code, kRejected) << result.out << result.err;
  EXPECT_THAT(result.err, HasSubstr(change.complaint));
  EXPECT_THAT(result.err, HasSubstr("proof.out:"));
}

const Change kChanges[] = {
    {"LeafAltered", "q(X, Y) => (r(Y) | t(X))", "q(X, Y) => (r(Y) & t(X))", "differs from 'a2'"},
    {"LeafVariableSwapped", "t(X) => s(X)", "t(X) => s(f(X))", "differs from 'a3'"},
    {"LeafOfAnotherName", "file('problem.p', a3)", "file('problem.p', a9)", "no formula 'a9'"},
    {"LeafRoleChanged", "fof(c1, conjecture", "fof(c1, axiom", "role was changed"},
    {"ConjectureNotNegated", "negated_conjecture, ~ ((", "negated_conjecture, ~ ~ ((",
     "not the negation"},
    {"OneOfTwoConjecturesNegated", "inference(negate,[status(cth)],[conjectures_1])",
     "inference(negate,[status(cth)],[c1])", "all conjectures together"},
    {"NormalFormLiteralChanged", "(~ t(X) | s(X)), inference(normalize",
     "(t(X) | s(X)), inference(normalize", "no normal form"},
    {"SkolemFunctionKnown", "new_symbols(skolem,[sk_1])", "new_symbols(skolem,[f])",
     "no new function"},
    {"SkolemArgumentDropped", "(~ p(X) | (q(X, sk_1(X)) & ((~ r(sk_1(X)) | s(X)) & (r(sk_1(X))",
     "(~ p(X) | (q(X, sk_1) & ((~ r(sk_1) | s(X)) & (r(sk_1)", "lacks an argument"},
    {"SkolemTermsDiffer", "q(X, sk_1(X)) & ((~ r(sk_1(X))", "q(X, sk_1(X)) & ((~ r(X)",
     "with terms for variables"},
    {"DefinedPredicateKnown", "definition, def_1 <=>", "definition, p(a) <=>", "not distinct"},
    {"ClauseLiteralDropped", "~ def_1 | ~ s(f(X)), inference(clausify",
     "~ s(f(X)), inference(clausify", "does not follow"},
    {"InstanceNegated", "cnf(instance_2, plain, ~", "cnf(instance_2, plain,", "no instance"},
    {"ParentUnknown", "[status(thm)],[clause_1]", "[status(thm)],[clause_77]", "does not stand"},
    {"ParentDropped", "[instance_1,", "[", "by propositional logic"},
    {"NameTaken", "cnf(instance_2,", "cnf(instance_1,", "another step has this name"},
    {"ConjectureTakenForGranted", "[instance_1,", "[c1,instance_1,", "takes a conjecture"},
    {"NoSource", ", inference(instantiate,[status(thm)],[clause_1])", "", "does not say where"},
};

INSTANTIATE_TEST_SUITE_P(Changes, ChangedProofTest, ::testing::ValuesIn(kChanges),
                         [](const auto& change) { return change.param.name; });

TEST_F(CheckProofTest, RenamedVariableOfOnePlace_IsRejected) {
  const std::string proof = Prove("cnf(a, axiom, p(X, X)). cnf(b, axiom, ~ p(Y, Y)).");
  const std::string changed = Replaced(proof, "cnf(a, axiom, p(X, X)", "cnf(a, axiom, p(X, Y)");
  EXPECT_EQ(Check(changed).exit_code, kRejected);
  EXPECT_EQ(Check(Replaced(proof, "cnf(a, axiom, p(X, X)", "cnf(a, axiom, p(Z, Z)")).exit_code,
            kVerified);
}

TEST_F(CheckProofTest, DefinitionOfKnownPredicate_IsRejected) {
  Prove("cnf(a, axiom, p). cnf(b, axiom, ~ p).");
  const CommandResult result = Check(
      "fof(d, definition, p <=> $false, introduced(definition,[new_symbols(definition,[p])],[])).\n"
      "cnf(a, axiom, p, file('problem.p', a)).\n"
      "cnf(z, plain, $false, inference(resolution,[status(thm)],[d,a])).\n");
  EXPECT_EQ(result.exit_code, kRejected);
  EXPECT_THAT(result.err, HasSubstr("proof.out:1:5: error: step 'd': rejected: 'p' is not new"));
}

TEST_F(CheckProofTest, ProofThatEndsEarly_IsRejected) {
  const CommandResult result = Check(WithoutLine(Prove(kProblem), "cnf(refutation_1"));
  EXPECT_EQ(result.exit_code, kRejected);
  EXPECT_THAT(result.err, HasSubstr("the last step is not $false"));
  EXPECT_EQ(Check("% nothing\n").exit_code, kRejected);
}

TEST_F(CheckProofTest, SaturationSteps_AreVerified) {
  Prove(
      "cnf(a, axiom, f(X, e) = X). cnf(b, axiom, p(f(c, Y)) | q(Y)). cnf(d, axiom, ~ p(c)). "
      "cnf(g, axiom, ~ q(e)).");
  const std::string leaves =
      "cnf(a, axiom, f(X, e) = X, file('problem.p', a)).\n"
      "cnf(b, axiom, p(f(c, Y)) | q(Y), file('problem.p', b)).\n"
      "cnf(d, axiom, ~ p(c), file('problem.p', d)).\n"
      "cnf(g, axiom, ~ q(e), file('problem.p', g)).\n";
  const std::string end =
      "cnf(2, plain, q(e), inference(resolution,[status(thm)],[1,d])).\n"
      "cnf(3, plain, $false, inference(resolution,[status(thm)],[2,g])).\n";
  const std::string right =
      "cnf(1, plain, p(c) | q(e), inference(superposition,[status(thm)],[a,b])).\n";
  const std::string wrong = "cnf(1, plain, p(c), inference(superposition,[status(thm)],[a,b])).\n";
  EXPECT_EQ(Check(leaves + right + end).exit_code, kVerified);
  EXPECT_EQ(Check(leaves + wrong + end).exit_code, kRejected);
}

TEST_F(CheckProofTest, StepsThatAreSimplifiedByOtherClauses_AreVerified) {
  Prove(
      "cnf(a, axiom, f(X, e) = X). cnf(b, axiom, ~ q(X) | p(f(f(X, e), e)) | r(X)). "
      "cnf(c, axiom, ~ r(f(e, Y))). cnf(d, axiom, q(f(e, e))). cnf(g, axiom, ~ p(f(X, X))).");
  const std::string leaves =
      "cnf(a, axiom, f(X, e) = X, file('problem.p', a)).\n"
      "cnf(b, axiom, ~ q(X) | p(f(f(X, e), e)) | r(X), file('problem.p', b)).\n"
      "cnf(c, axiom, ~ r(f(e, Y)), file('problem.p', c)).\n"
      "cnf(d, axiom, q(f(e, e)), file('problem.p', d)).\n"
      "cnf(g, axiom, ~ p(f(X, X)), file('problem.p', g)).\n";
  const std::string step = "cnf(1, plain, p(e), inference(resolution,[status(thm)],[b,d,a,c])).\n";
  const std::string end = "cnf(2, plain, $false, inference(resolution,[status(thm)],[1,g,a])).\n";
  EXPECT_EQ(Check(leaves + step + end).exit_code, kVerified);
  EXPECT_EQ(Check(leaves + Replaced(step, ",a,c]", ",a]") + end).exit_code, kRejected);
  EXPECT_EQ(Check(leaves + step + Replaced(end, "[1,g,a]", "[1,g,d]")).exit_code, kRejected);
}

TEST_F(CheckProofTest, Leaves_AreTheTextOfTheProblem) {
  const std::string proof = Prove(
      "fof(a, axiom, ( ! [X_1] :\n  ( p(X_1)=>(q) ) )).\nfof(b, axiom, (p('a  b'))).\n"
      "fof(c, conjecture, (q)|(r)).");
  EXPECT_THAT(proof, HasSubstr("fof(a, axiom, ( ! [X_1] : ( p(X_1)=>(q) ) ), file("));
  EXPECT_THAT(proof, HasSubstr("fof(b, axiom, (p('a  b')), file("));
  EXPECT_THAT(proof, HasSubstr("negated_conjecture, ~ ((q)|(r)), inference(negate"));
  EXPECT_EQ(Check(proof).exit_code, kVerified);
}

TEST_F(CheckProofTest, WhatCannotBeChecked_IsSaid) {
  Prove("cnf(a, axiom, p). cnf(b, axiom, ~ p).");
  const CommandResult result = Check(
      "cnf(t, plain, subset(a, a), introduced(theory,[theory(sets)],[])).\n"
      "cnf(a, axiom, p, file('problem.p', a)).\ncnf(b, axiom, ~ p, file('problem.p', b)).\n"
      "cnf(z, plain, $false, inference(resolution,[status(thm)],[a,b,t])).\n");
  EXPECT_EQ(result.exit_code, kUnchecked);
  EXPECT_THAT(result.err, HasSubstr("step 't': not checked: "));
  EXPECT_THAT(result.out, HasSubstr("not checked: 3 steps verified, 0 rejected, 1 not checked"));
}

constexpr std::string_view kComputing = R"(
tff(a, axiom, level(0)).
tff(b, axiom, ! [X: $int] : ((level(X) & $less(X, 2)) => level($sum(X, 1)))).
tff(d, axiom, ! [X: $int] : (level(X) => share($quotient(X, 2), $to_int(2.5)))).
tff(c, conjecture, level(2) & share($quotient(2, 2), 2) & 0.5 != 0.25).
)";

TEST_F(CheckProofTest, ArithmeticSteps_AreComputedAnew) {
  const std::string proof = Prove(kComputing);
  EXPECT_THAT(proof, HasSubstr("introduced(theory,[theory(arithmetic)],[])"));
  const CommandResult result = Check(proof);
  EXPECT_EQ(result.exit_code, kVerified) << result.err;
  for (const auto& [right, wrong] :
       {std::pair{"$less(1, 2)", "$less(2, 2)"},
        {"~ level($sum(1, 1)) | level(2)", "~ level($sum(1, 1)) | level(3)"},
        {"$to_int(2.5)) | share(1, 2)", "$to_int(2.5)) | share(1, 3)"}}) {
    const CommandResult changed = Check(Replaced(proof, right, wrong));
    EXPECT_EQ(changed.exit_code, kRejected) << proof;
    EXPECT_THAT(changed.err, HasSubstr("it is not true by arithmetic")) << wrong;
  }
}

TEST_F(CheckProofTest, ArithmeticOfSteps_IsExact) {
  const auto step = [](std::string_view clause) {
    return fmt::format("cnf(t, plain, {}, introduced(theory,[theory(arithmetic)],[])).\n", clause);
  };
  Prove("cnf(a, axiom, p). cnf(b, axiom, ~ p).");
  for (const char* const clause :
       {"$sum(0.1, 0.2) = 0.3", "$quotient(6, 3) = 2", "$quotient_e(-7, 2) = -4",
        "$remainder_e(-7, -2) = 1", "$round(2.5) = 2.0", "$truncate(-2.5) = -2.0",
        "$ceiling($uminus(2.5)) = -2.0", "$less(1.0E-3, 0.0011)", "$is_int(2.0)",
        "p(f($max(1, 2))) | ~ p(f($abs(-2)))", "$min(X, 1) = $min(X, $sum(0, 1))"}) {
    EXPECT_THAT(Check(step(clause)).err, Not(HasSubstr("step 't'"))) << clause;
  }
  for (const char* const clause :
       {"$sum(0.1, 0.2) != 0.3", "$quotient(7, 3) = 2", "$less(2, 2)", "$is_int(2.5)", "2 = 2.0",
        "p(1) | ~ p(1.0)", "$quotient(1, 0) = 0", "$less(X, $sum(X, 1))", "p(1) | p(1)"}) {
    EXPECT_THAT(Check(step(clause)).err, HasSubstr("step 't': rejected")) << clause;
  }
}

TEST_F(CheckProofTest, FormulasOfOneName_AreToldApart) {
  const std::string proof =
      Prove("cnf(a, axiom, p(b)). cnf(a, axiom, ~ p(X)). cnf(a_1, axiom, q).");
  EXPECT_THAT(proof, HasSubstr("cnf(a_2, axiom, "));
  EXPECT_EQ(Check(proof).exit_code, kVerified);
}

TEST_F(CheckProofTest, Json_NamesTheWrongStep) {
  const std::string proof = Replaced(Prove(kProblem), "[instance_1,", "[");
  const auto report = nlohmann::json::parse(Check(proof, {"--json"}).out);
  EXPECT_EQ(report["verdict"], "rejected");
  EXPECT_EQ(report["rejected"], 1);
  EXPECT_EQ(report["steps"][0]["name"], "refutation_1");
  EXPECT_EQ(report["steps"][0]["column"], 5);
}

TEST_F(CheckProofTest, UnreadableFiles_AreRefused) {
  Prove(kProblem);
  EXPECT_EQ(Check("cnf(a, axiom, p(.\n").exit_code, kUnreadable);
  EXPECT_EQ(RunLatchwork({"check-proof", "nowhere.p", "proof.out"}, scratch_.path()).exit_code,
            kUnreadable);
}

}  // namespace
}  // namespace latchwork::testing

// SPDX-License-Identifier: BSD-3-Clause
//
// What scripts around provers rely on: one SZS status line, exit codes, limits, signals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
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
using ::testing::StartsWith;

constexpr std::string_view kTheorem =
    "fof(a, axiom, ![X] : (p(X) => q(X))). fof(b, axiom, p(a)). fof(c, conjecture, ?[X] : q(X)).";
/// The space of a tableau has no end and holds no proof.
constexpr std::string_view kEndless =
    "cnf(a, axiom, p(X, Y) | ~ p(f(X), Y) | ~ p(X, g(Y))). cnf(b, axiom, p(X, X) | p(f(X), g(X)))."
    "cnf(c, axiom, ~ p(a, b)). cnf(d, axiom, p(g(X), Y) | ~ p(Y, f(X)) | p(Y, X)).";

std::size_t CountStatusLines(const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find("% SZS status "); at != std::string::npos;
       at = text.find("% SZS status ", at + 1)) {
    ++count;
  }
  return count;
}

class ProveTest : public ::testing::Test {
 protected:
  void Write(const std::string& name, std::string_view text) {
    WriteText(scratch_.path() / name, std::string(text));
  }
  CommandResult Prove(std::string_view text, const std::vector<std::string>& options = {}) {
    Write("problem.p", text);
    std::vector<std::string> arguments{"prove", "problem.p"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunLatchwork(arguments, scratch_.path());
  }
  CommandResult Shell(const std::string& script) { return RunShell(script, scratch_.path()); }

  TemporaryFolder scratch_;
};

TEST_F(ProveTest, Conjecture_IsTheoremOrCounterSatisfiable) {
  const CommandResult proved = Prove(kTheorem);
  EXPECT_EQ(proved.exit_code, 0);
  EXPECT_EQ(proved.out, "% SZS status Theorem for problem.p\n");
  const CommandResult refuted = Prove("fof(a, axiom, p(a)). fof(c, conjecture, q(a)).");
  EXPECT_EQ(refuted.exit_code, 1);
  EXPECT_EQ(refuted.out, "% SZS status CounterSatisfiable for problem.p\n");
}

TEST_F(ProveTest, RealsThatWouldBeRounded_ProveNothing) {
  for (const std::string_view conjecture :
       {"$sum(0.1, 0.2) != 0.3", "$greater($sum(0.1, 0.2), 0.3)", "$sum(0.1, 0.2) = 0.3",
        "$product($quotient(1.0, 3.0), 3.0) = 1.0", "$quotient(1, 3) != $quotient(1.0, 3.0)",
        "$sum(9007199254740992.0, 1.0) = 9007199254740992.0"}) {
    const CommandResult result = Prove("tff(c, conjecture, " + std::string(conjecture) + ").");
    EXPECT_EQ(result.out, "% SZS status GaveUp for problem.p\n") << conjecture;
  }
}

TEST_F(ProveTest, RealsThatAreExact_AreComputed) {
  for (const std::string_view conjecture :
       {"$sum(0.5, 0.25) = 0.75", "$less(0.1, 0.2)", "0.1 != 0.2", "$product(1.5, -2.0) = -3.0",
        "$difference(1.25, 0.25) = 1.0", "$quotient(1.5, 2.0) = 0.75", "$floor(0.1) = 0.0",
        "$to_real(3) = 3.0"}) {
    const CommandResult result = Prove("tff(c, conjecture, " + std::string(conjecture) + ").");
    EXPECT_EQ(result.out, "% SZS status Theorem for problem.p\n") << conjecture;
  }
}

/// What holds of all individuals, or all integers, holds of no other numbers.
TEST_F(ProveTest, TypesOfTff_AreKeptApart) {
  const std::string one = "tff(a, axiom, ![X: $i]: X = c). tff(b, axiom, p(1) & ~ p(2)).";
  EXPECT_THAT(Prove(one + "tff(d, conjecture, $false).").out, Not(HasSubstr("Theorem")));
  EXPECT_THAT(Prove(one + "tff(d, conjecture, f(c, 1) = f(f(c, 2), 2)).").out,
              StartsWith("% SZS status Theorem"));
  const std::string whole =
      "tff(a, axiom, ![X: $int]: ~ ($less(0, X) & $less(X, 1))). tff(b, axiom, q(0.5) & r(7)).";
  EXPECT_THAT(Prove(whole + "tff(d, conjecture, $false).").out, Not(HasSubstr("Theorem")));
  EXPECT_THAT(Prove(whole + "tff(d, axiom, ![X: $int]: (($less(3, X) & r(X)) => s(X)))."
                            "tff(e, conjecture, ?[X: $int]: s(X)).")
                  .out,
              StartsWith("% SZS status Theorem"));
  const CommandResult wrong = Prove("tff(a, axiom, p(1)). tff(b, axiom, p(2.5)).");
  EXPECT_EQ(wrong.exit_code, 3);
  EXPECT_THAT(wrong.err, HasSubstr("argument 1 of 'p' is $int, but '2.5' is $real"));
}

/// Only the facts of arithmetic themselves are left for others to check.
TEST_F(ProveTest, ProofsThatCompute_SayWhatWasComputed) {
  const std::string conjecture =
      "tff(a, axiom, ![X] : (p(X) => p($sum(X, 1)))). tff(b, axiom, p(1))."
      "tff(c, conjecture, p(3) & $product(0.5, 4.0) = 2.0).";
  const CommandResult result = Prove(conjecture, {"--proof"});
  EXPECT_THAT(result.out, StartsWith("% SZS status Theorem"));
  EXPECT_THAT(result.out, HasSubstr("$sum(1, 1)"));
  Write("proof.p", result.out);
  const CommandResult checked =
      RunLatchwork({"check-proof", "problem.p", "proof.p"}, scratch_.path());
  EXPECT_THAT(checked.out, HasSubstr(", 0 rejected,")) << checked.err << result.out;
  EXPECT_THAT(Prove(conjecture, {"--why"}).out, HasSubstr("arithmetic"));
}

TEST_F(ProveTest, Clauses_AreUnsatisfiableOrSatisfiable) {
  const CommandResult proved = Prove("cnf(a, axiom, p(X)). cnf(b, negated_conjecture, ~ p(a)).");
  EXPECT_EQ(proved.exit_code, 0);
  EXPECT_EQ(proved.out, "% SZS status Unsatisfiable for problem.p\n");
  const CommandResult refuted = Prove("cnf(a, axiom, p(X)). cnf(b, axiom, ~ q(a)).");
  EXPECT_EQ(refuted.exit_code, 1);
  EXPECT_EQ(refuted.out, "% SZS status Satisfiable for problem.p\n");
}

TEST_F(ProveTest, AxiomsThatContradictEachOther_AreNamedSoWithTheProof) {
  const CommandResult result =
      Prove("fof(a, axiom, p). fof(b, axiom, ~ p). fof(c, conjecture, q).", {"--proof"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, StartsWith("% SZS status ContradictoryAxioms for problem.p\n"));
}

TEST_F(ProveTest, Proof_StandsBetweenItsMarks) {
  const CommandResult result = Prove(kTheorem, {"--proof"});
  EXPECT_THAT(result.out, HasSubstr("% SZS output start Proof for problem.p\n"));
  EXPECT_THAT(result.out, HasSubstr("% SZS output end Proof for problem.p\n"));
  EXPECT_THAT(result.out, HasSubstr("file('problem.p', a)"));
  EXPECT_THAT(Prove(kTheorem, {"--no-proof"}).out, Not(HasSubstr("output")));
}

TEST_F(ProveTest, Question_IsAnswered) {
  const std::string axiom = "fof(a, axiom, p(f(b))). ";
  const CommandResult result = Prove(axiom + "fof(c, question, ?[X] : p(X)).");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("% SZS answers Tuple [[f(b)]|_] for problem.p\n"));
  const std::string conjecture = axiom + "fof(c, conjecture, ?[X] : p(X)).";
  EXPECT_THAT(Prove(conjecture).out, Not(HasSubstr("answers")));
  EXPECT_THAT(Prove(conjecture, {"--answers"}).out, HasSubstr("answers Tuple [[f(b)]|_]"));
}

TEST_F(ProveTest, Json_HoldsEverything) {
  const CommandResult result = Prove(kTheorem, {"--json", "--proof", "--answers"});
  const auto report = nlohmann::json::parse(result.out);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(report["status"], "Theorem");
  EXPECT_EQ(report["answers"][0][0], "a");
  EXPECT_THAT(report["proof"].back().get<std::string>(), HasSubstr("$false"));
}

TEST_F(ProveTest, Why_ExplainsProofAndFailure) {
  const CommandResult proved = Prove(kTheorem, {"--why"});
  EXPECT_EQ(proved.exit_code, 0);
  EXPECT_EQ(proved.out,
            "% SZS status Theorem for problem.p\n"
            "% c holds with X = a, since\n"
            "%   q(a): by a with X = a, since\n"
            "%     p(a): by b\n"
            "% Formulas used: a, b, c.\n");
  const std::string_view failing = "fof(a, axiom, p(b)). fof(c, conjecture, p(d)).";
  const CommandResult failed = Prove(failing, {"--why"});
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_THAT(failed.out, StartsWith("% SZS status CounterSatisfiable for problem.p\n"));
  EXPECT_THAT(failed.out, HasSubstr("%   no clause concludes p(d): nearest p(b) of a: "));
  const auto report = nlohmann::json::parse(Prove(failing, {"--why", "--json"}).out);
  EXPECT_EQ(report["why"][0]["depth"], 0);
  EXPECT_FALSE(report["why"][0]["text"].get<std::string>().empty());
}

TEST_F(ProveTest, Why_SaysWhatEndedTheSearch) {
  const CommandResult result = Prove(kEndless, {"--why", "--strategy", "goal", "--time", "0.2"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("% SZS status Timeout for problem.p\n"));
  EXPECT_EQ(CountStatusLines(result.out), 1);
  EXPECT_THAT(result.out, HasSubstr("it had 0.2 s (--time)"));
}

TEST_F(ProveTest, BadInput_HasAStatusToo) {
  const CommandResult syntax = Prove("fof(a, axiom, p(.");
  EXPECT_EQ(syntax.exit_code, 3);
  EXPECT_EQ(syntax.out, "% SZS status SyntaxError for problem.p\n");
  EXPECT_THAT(syntax.err, HasSubstr("problem.p:1:17: error: "));
  const CommandResult missing = RunLatchwork({"prove", "nowhere.p"}, scratch_.path());
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_EQ(missing.out, "% SZS status InputError for nowhere.p\n");
}

TEST_F(ProveTest, StandardInput_IsRead) {
  Write("problem.p", kTheorem);
  const CommandResult result = Shell("latchwork prove - < problem.p");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "% SZS status Theorem for -\n");
}

TEST_F(ProveTest, Includes_AreFoundByOptionThenByVariable) {
  std::filesystem::create_directories(scratch_.path() / "one/Axioms");
  std::filesystem::create_directories(scratch_.path() / "two/Axioms");
  Write("one/Axioms/a.ax", "fof(a, axiom, p).");
  Write("two/Axioms/a.ax", "fof(a, axiom, q).");
  Write("problem.p", "include('Axioms/a.ax'). fof(c, conjecture, p).");
  EXPECT_EQ(Shell("TPTP=one latchwork prove problem.p").exit_code, 0);
  EXPECT_EQ(Shell("TPTP=two latchwork prove problem.p").exit_code, 1);
  EXPECT_EQ(Shell("TPTP=two latchwork prove --tptp one problem.p").exit_code, 0);
  EXPECT_EQ(Shell("unset TPTP; latchwork prove problem.p").exit_code, 3);
}

TEST_F(ProveTest, Example_IsProvedAndItsProofChecked) {
  const std::string file = LATCHWORK_SOURCE_DIR "/examples/tptp/way.p";
  const CommandResult answer = Shell("latchwork prove --answers " + file);
  EXPECT_EQ(answer.exit_code, 0);
  EXPECT_THAT(answer.out, HasSubstr("% SZS answers Tuple [[e]|_]"));
  EXPECT_EQ(Shell("latchwork prove --proof " + file + " | latchwork check-proof " + file).exit_code,
            0);
}

TEST_F(ProveTest, Time_IsCpuTime) {
  const CommandResult result = Prove(kEndless, {"--strategy", "goal", "--time", "0.2"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("% SZS status Timeout for problem.p\n"));
  EXPECT_EQ(CountStatusLines(result.out), 1U);
}

TEST_F(ProveTest, LimitOfTheShell_IsATimeoutToo) {
  Write("problem.p", kEndless);
  const CommandResult result =
      Shell("ulimit -S -t 1; latchwork prove --strategy goal --time 100 problem.p");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out.substr(0, result.out.find('\n')), "% SZS status Timeout for problem.p");
}

TEST_F(ProveTest, Signals_LeadToOneStatusLine) {
  Write("problem.p", kEndless);
  const auto signalled = [&](const std::string& signal) {
    // The first status line that is written is the only one; the process ends by itself.
    return Shell(
        "latchwork prove --strategy goal --time 100 problem.p & "
        "while ! grep -q prove /proc/$!/cmdline; do :; done; while [ $(cut -d' ' -f14 "
        "/proc/$!/stat) -lt 5 ]; do :; done; "
        "kill -s " +
        signal + " $!; wait $!");
  };
  EXPECT_EQ(signalled("TERM").out, "% SZS status Forced for problem.p\n");
  EXPECT_EQ(signalled("XCPU").out, "% SZS status Timeout for problem.p\n");
  EXPECT_EQ(signalled("ALRM").out, "% SZS status Timeout for problem.p\n");
  EXPECT_EQ(signalled("TERM").exit_code, 1);
}

#ifndef __SANITIZE_ADDRESS__
TEST_F(ProveTest, Memory_IsKeptTo) {
  std::string clauses;
  for (int i = 0; i < 200'000; ++i) {
    clauses += "cnf(c" + std::to_string(i) + ", axiom, p(" + std::to_string(i) + ") | q(X, Y)).\n";
  }
  const CommandResult result = Prove(clauses, {"--memory", "24"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "% SZS status ResourceOut for problem.p\n");
}
#endif

TEST_F(ProveTest, Json_IsAllThatIsPrinted) {
  const auto bad = nlohmann::json::parse(Prove("fof(a, axiom,", {"--json"}).out);
  EXPECT_EQ(bad.at("status"), "SyntaxError");
  EXPECT_THAT(bad.at("message"), HasSubstr("problem.p:1:"));
  const auto missing = nlohmann::json::parse(Shell("latchwork prove none.p --json").out);
  EXPECT_EQ(missing.at("status"), "InputError");
  const auto late = nlohmann::json::parse(
      Prove(kEndless, {"--json", "--time", "0.3", "--strategy", "complete"}).out);
  EXPECT_EQ(late.at("status"), "Timeout");
  EXPECT_NE(late.at("message"), "");
}

TEST_F(ProveTest, PipeWithAByteOrderMark_IsRead) {
  Write("problem.p", "\xef\xbb\xbf" + std::string(kTheorem));
  const CommandResult result = Shell("mkfifo pipe; cat problem.p > pipe & latchwork prove pipe");
  EXPECT_EQ(result.out, "% SZS status Theorem for pipe\n") << result.err;
}

}  // namespace
}  // namespace latchwork::testing

// SPDX-License-Identifier: BSD-3-Clause
// Random clause sets, judged by brute force. LATCHWORK_CLAUSE_SETS says how many of each language
// are tried.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <ostream>
#include <string>

#include "latchwork/logic/tptp.h"
#include "reasoners/pttp/strategies/prover.h"
#include "tests/reasoners/pttp/random_clauses.h"

namespace latchwork::pttp {
namespace {

constexpr std::uint64_t kUsualSets = 8500;

struct Case {
  std::string name;
  Language language;
  /// In a hundred sets: at least so many proved, refuted, and at most so many undecided.
  int proved = 0;
  int refuted = 0;
  int undecided = 0;
};

void PrintTo(const Case& value, std::ostream* stream) { *stream << value.name; }

struct Tally {
  int proved = 0;
  int refuted = 0;
  int undecided = 0;
};

void Try(const Language& language, std::uint64_t number, Tally& tally) {
  const auto clauses = MakeRandomClauses(language, number);
  const std::string text = Text(clauses);
  logic::SymbolTable symbols;
  const auto file = logic::ReadTptp(text, "random", symbols);
  ASSERT_TRUE(file.diagnostics.empty()) << Format(file.diagnostics);
  ProverOptions options;
  options.budget.inferences = 1'000;
  options.budget.depth = 12;
  const ProverResult result = Prove(file.formulas, symbols, "random", options);
  const Truth truth = JudgeByBruteForce(clauses, language);
  if (result.status == Szs::kUnsatisfiable) {
    ++tally.proved;
    EXPECT_NE(truth, Truth::kSatisfiable) << text;
  } else if (result.status == Szs::kSatisfiable) {
    ++tally.refuted;
    EXPECT_NE(truth, Truth::kUnsatisfiable) << text;
  } else {
    ++tally.undecided;
  }
}

std::uint64_t Sets() {
  const char* const wanted = std::getenv("LATCHWORK_CLAUSE_SETS");
  return wanted == nullptr ? kUsualSets : std::strtoull(wanted, nullptr, 10);
}

class SoundnessTest : public ::testing::TestWithParam<Case> {};

TEST_P(SoundnessTest, AgreesWithBruteForce) {
  const Case& each = GetParam();
  const std::uint64_t count = Sets();
  Tally tally;
  for (std::uint64_t number = 0; number < count && !HasFailure(); ++number) {
    Try(each.language, number, tally);
  }
  RecordProperty("proved", tally.proved);
  RecordProperty("refuted", tally.refuted);
  RecordProperty("undecided", tally.undecided);
  const auto sets = static_cast<double>(count);
  EXPECT_GE(100 * tally.proved / sets, each.proved);
  EXPECT_GE(100 * tally.refuted / sets, each.refuted);
  EXPECT_LE(100 * tally.undecided / sets, each.undecided);
}

const Case kCases[] = {
    {"GroundClauses", {false, false, false}, 12, 15, 1},
    {"GroundClausesWithFunctions", {false, true, false}, 10, 15, 1},
    {"GroundClausesWithEquality", {false, true, true}, 5, 0, 95},
    {"Clauses", {true, false, false}, 15, 10, 30},
    {"ClausesWithFunctions", {true, true, false}, 15, 5, 60},
    {"ClausesWithFunctionsAndEquality", {true, true, true}, 10, 0, 90},
};

INSTANTIATE_TEST_SUITE_P(Languages, SoundnessTest, ::testing::ValuesIn(kCases),
                         [](const auto& value) { return value.param.name; });

}  // namespace
}  // namespace latchwork::pttp

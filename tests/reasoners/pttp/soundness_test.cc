// SPDX-License-Identifier: BSD-3-Clause
// Random clause sets without functions, judged by trying every Herbrand interpretation.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "latchwork/logic/tptp.h"
#include "latchwork/sdk/random.h"
#include "reasoners/pttp/prover.h"

namespace latchwork::pttp {
namespace {

struct RandomLiteral {
  bool positive = true;
  std::size_t predicate = 0;
  std::array<int, 2> arguments{};  ///< 0, 1: constants; 2, 3, 4: variables.
};
using RandomClause = std::vector<RandomLiteral>;

constexpr std::array<std::size_t, 5> kArities{0, 0, 1, 1, 2};
constexpr std::array<unsigned, 5> kFirstAtom{0, 1, 2, 4, 6};
constexpr unsigned kAtoms = 10;

class ClauseMaker {
 public:
  explicit ClauseMaker(std::uint64_t number) : number_(number) {}

  std::vector<RandomClause> Make(bool first_order) {
    std::vector<RandomClause> clauses(3 + Pick(7));
    for (RandomClause& clause : clauses) {
      clause.resize(1 + Pick(3));
      for (RandomLiteral& literal : clause) {
        literal.positive = Pick(2) == 0;
        literal.predicate = first_order ? 1 + Pick(4) : Pick(5);
        for (int& argument : literal.arguments)
          argument = static_cast<int>(Pick(first_order ? 5 : 2));
      }
    }
    return clauses;
  }

 private:
  std::size_t Pick(std::size_t count) {
    return static_cast<std::size_t>(stream_.Index(count, number_, draws_++));
  }

  sdk::RandomStream stream_{7, "clauses"};
  std::uint64_t number_;
  std::uint64_t draws_ = 0;
};

std::string Text(const std::vector<RandomClause>& clauses) {
  static constexpr std::array<const char*, 5> kTerms{"a", "b", "X", "Y", "Z"};
  static constexpr std::array<const char*, 5> kPredicates{"s", "t", "p", "q", "r"};
  std::string text;
  for (std::size_t i = 0; i < clauses.size(); ++i) {
    text += "cnf(c" + std::to_string(i) + ", axiom, ";
    for (std::size_t j = 0; j < clauses[i].size(); ++j) {
      const RandomLiteral& literal = clauses[i][j];
      text += std::string(j > 0 ? " | " : "") + (literal.positive ? "" : "~ ") +
              kPredicates[literal.predicate];
      const std::size_t arity = kArities[literal.predicate];
      for (std::size_t k = 0; k < arity; ++k) {
        text += (k == 0 ? "(" : ",") +
                std::string(kTerms[static_cast<std::size_t>(literal.arguments[k])]);
      }
      if (arity > 0) text += ")";
    }
    text += ").\n";
  }
  return text;
}

unsigned AtomOf(const RandomLiteral& literal, unsigned assignment) {
  unsigned offset = 0;
  for (std::size_t k = 0; k < kArities[literal.predicate]; ++k) {
    const int term = literal.arguments[k];
    const unsigned value = term < 2 ? static_cast<unsigned>(term)
                                    : (assignment >> static_cast<unsigned>(term - 2)) & 1U;
    offset = 2 * offset + value;
  }
  return kFirstAtom[literal.predicate] + offset;
}

bool Holds(const RandomClause& clause, unsigned interpretation) {
  for (unsigned assignment = 0; assignment < 8; ++assignment) {
    bool holds = false;
    for (const RandomLiteral& literal : clause) {
      holds = holds ||
              (((interpretation >> AtomOf(literal, assignment)) & 1U) != 0) == literal.positive;
    }
    if (!holds) return false;
  }
  return true;
}

bool IsSatisfiable(const std::vector<RandomClause>& clauses) {
  for (unsigned interpretation = 0; interpretation < (1U << kAtoms); ++interpretation) {
    bool model = true;
    for (const RandomClause& clause : clauses) model = model && Holds(clause, interpretation);
    if (model) return true;
  }
  return false;
}

struct Tally {
  int proved = 0;
  int refuted = 0;
  int undecided = 0;
};

Tally Compare(bool first_order, std::uint64_t first, std::uint64_t count) {
  Tally tally;
  for (std::uint64_t number = first; number < first + count; ++number) {
    const auto clauses = ClauseMaker(number).Make(first_order);
    const std::string text = Text(clauses);
    logic::SymbolTable symbols;
    const auto file = logic::ReadTptp(text, "random", symbols);
    EXPECT_TRUE(file.diagnostics.empty()) << Format(file.diagnostics);
    ProverOptions options;
    options.budget.inferences = 100'000;
    options.budget.depth = 40;
    const ProverResult result = Prove(file.formulas, symbols, "random", options);
    const bool satisfiable = IsSatisfiable(clauses);
    switch (result.status) {
      case Szs::kUnsatisfiable:
        ++tally.proved;
        EXPECT_FALSE(satisfiable) << text;
        break;
      case Szs::kSatisfiable:
        ++tally.refuted;
        EXPECT_TRUE(satisfiable) << text;
        break;
      default:
        ++tally.undecided;
    }
  }
  return tally;
}

TEST(SoundnessTest, AgreesWithTruthTablesOnGroundClauses) {
  const Tally tally = Compare(false, 0, 4000);
  EXPECT_GT(tally.proved, 500);
  EXPECT_GT(tally.refuted, 500);
  EXPECT_LT(tally.undecided, 5);
}

TEST(SoundnessTest, AgreesWithHerbrandInterpretations) {
  const Tally tally = Compare(true, 10'000, 3000);
  EXPECT_GT(tally.proved, 500);
  EXPECT_GT(tally.refuted, 300);
  EXPECT_LT(tally.undecided, 600);
}

}  // namespace
}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tableau/tableau.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/clausify.h"
#include "latchwork/logic/tptp.h"

namespace latchwork::pttp {
namespace {

using logic::Clause;

constexpr std::size_t kMemory = std::size_t{256} << 20U;

std::vector<Strategy> AllStrategies() {
  std::vector<Strategy> all;
  for (const Cut cut : {Cut::kNone, Cut::kExclusive, Cut::kInclusive}) {
    for (const Start start : {Start::kConjecture, Start::kNegative, Start::kPositive}) {
      for (const BodyOrder order :
           {BodyOrder::kWritten, BodyOrder::kFewest, BodyOrder::kReversed}) {
        for (const bool lemmata : {false, true}) {
          all.push_back({.cut = cut, .start = start, .order = order, .lemmata = lemmata});
        }
      }
    }
  }
  return all;
}

class TableauTest : public ::testing::Test {
 protected:
  std::vector<Clause> Read(std::string_view text) {
    const logic::TptpFile file = logic::ReadTptp(text, "test.p", symbols_);
    EXPECT_TRUE(file.diagnostics.empty());
    return logic::Clausify(file.formulas, symbols_);
  }
  TableauEnd Search(const std::vector<Clause>& clauses, const Strategy& strategy = {}) {
    Matrix matrix(clauses, strategy);
    Tableau tableau(matrix, strategy, kMemory, [] { return false; });
    const TableauEnd end = tableau.Search();
    inferences_ = tableau.inferences();
    if (end == TableauEnd::kClosed) refutation_ = tableau.Refutation();
    return end;
  }

  logic::SymbolTable symbols_;
  std::vector<ClauseInstance> refutation_;
  std::uint64_t inferences_ = 0;
};

/// Whether no assignment to the atoms makes all of the clauses true. Atoms are told apart as text.
bool Contradictory(const std::vector<std::vector<logic::Literal>>& clauses) {
  std::map<std::string, unsigned> atoms;
  for (const auto& clause : clauses) {
    for (const logic::Literal& literal : clause) {
      atoms.try_emplace(ToString(literal.atom), static_cast<unsigned>(atoms.size()));
    }
  }
  if (atoms.size() > 20) return false;
  for (std::uint32_t model = 0; model < (1U << atoms.size()); ++model) {
    bool all = true;
    for (const auto& clause : clauses) {
      bool any = false;
      for (const logic::Literal& literal : clause) {
        any =
            any || ((model >> atoms.at(ToString(literal.atom))) & 1U) == (literal.positive ? 1 : 0);
      }
      all = all && any;
    }
    if (all) return false;
  }
  return true;
}

std::vector<std::vector<logic::Literal>> LiteralsOf(const std::vector<ClauseInstance>& instances) {
  std::vector<std::vector<logic::Literal>> clauses;
  for (const ClauseInstance& instance : instances) clauses.push_back(instance.literals);
  return clauses;
}

TEST_F(TableauTest, Modus_Closes) {
  const auto clauses = Read(
      "cnf(a,axiom, p(X) | ~ q(X)). cnf(b,axiom, q(f(a))). "
      "cnf(c,negated_conjecture, ~ p(f(Y))).");
  EXPECT_EQ(Search(clauses), TableauEnd::kClosed);
  EXPECT_EQ(refutation_.size(), 3U);
  EXPECT_TRUE(Contradictory(LiteralsOf(refutation_)));
}

TEST_F(TableauTest, OccursCheck_IsMade) {
  EXPECT_EQ(Search(Read("cnf(a,axiom, p(X,X)). cnf(b,axiom, ~ p(Y,f(Y))).")),
            TableauEnd::kSaturated);
  EXPECT_EQ(Search(Read("cnf(a,axiom, p(X,f(X))). cnf(b,axiom, ~ p(Y,Y)).")),
            TableauEnd::kSaturated);
  EXPECT_EQ(Search(Read("cnf(a,axiom, p(X,Y,f(X),f(Y))). cnf(b,axiom, ~ p(f(Z),W,Z,W)).")),
            TableauEnd::kSaturated);
}

TEST_F(TableauTest, Reduction_ClosesWhatExtensionCannot) {
  const auto clauses = Read(
      "cnf(a,axiom, p | q). cnf(b,axiom, ~ p | q). "
      "cnf(c,axiom, p | ~ q). cnf(d,axiom, ~ p | ~ q).");
  for (const Strategy& strategy : AllStrategies()) {
    EXPECT_EQ(Search(clauses, strategy), TableauEnd::kClosed);
  }
}

TEST_F(TableauTest, EveryStrategy_ClosesWithAContradictionOfInstances) {
  const auto clauses = Read(
      "fof(a,axiom, ! [X] : (human(X) => mortal(X))). fof(b,axiom, human(socrates) | human(plato))."
      "fof(c,conjecture, ? [X] : mortal(X)).");
  for (const Strategy& strategy : AllStrategies()) {
    ASSERT_EQ(Search(clauses, strategy), TableauEnd::kClosed);
    EXPECT_TRUE(Contradictory(LiteralsOf(refutation_)));
  }
}

TEST_F(TableauTest, FiniteSpace_SaturatesOnlyUnderACompleteStrategy) {
  const auto clauses = Read(
      "fof(a,axiom, p(a) & p(b) & (! [X] : (p(X) => r(X))) & q(c)). "
      "fof(b,conjecture, ? [X] : (r(X) & q(X))).");
  EXPECT_EQ(Search(clauses), TableauEnd::kSaturated);
  EXPECT_EQ(Search(clauses, {.cut = Cut::kInclusive}), TableauEnd::kGaveUp);
  EXPECT_EQ(Search(clauses, {.start = Start::kConjecture}), TableauEnd::kGaveUp);
}

TEST_F(TableauTest, ExclusiveCut_MissesAProofThatNeedsASecondSolution) {
  const auto clauses = Read(
      "cnf(a,axiom, p(X) | ~ s(X)). cnf(b,axiom, s(a)). cnf(c,axiom, s(b))."
      "cnf(d,axiom, q(b)). cnf(e,negated_conjecture, ~ p(X) | ~ q(X)).");
  EXPECT_EQ(Search(clauses), TableauEnd::kClosed);
  EXPECT_EQ(Search(clauses, {.cut = Cut::kExclusive}), TableauEnd::kGaveUp);
}

TEST_F(TableauTest, Lemma_SavesASecondProof) {
  const auto clauses = Read(
      "cnf(a,axiom, p(X) | ~ q(X) | ~ r(X)). cnf(b,axiom, q(X) | ~ s(X)). cnf(c,axiom, r(X) | ~ "
      "s(X))."
      "cnf(d,axiom, s(X) | ~ t(X)). cnf(e,axiom, t(X) | ~ u(X)). cnf(f,axiom, u(a))."
      "cnf(g,negated_conjecture, ~ s(a) | ~ p(a)).");
  ASSERT_EQ(Search(clauses, {.lemmata = false}), TableauEnd::kClosed);
  const std::uint64_t without = inferences_;
  ASSERT_EQ(Search(clauses, {.lemmata = true}), TableauEnd::kClosed);
  EXPECT_LT(inferences_, without);
}

TEST_F(TableauTest, Ladder_OfThousandStepsDoesNotRecurse) {
  std::string text = "cnf(zero,axiom, p(n0)). cnf(goal,negated_conjecture, ~ p(n1000)).";
  for (int i = 0; i < 1000; ++i) {
    text += "cnf(step,axiom, p(n" + std::to_string(i + 1) + ") | ~ p(n" + std::to_string(i) + ")).";
  }
  EXPECT_EQ(Search(Read(text)), TableauEnd::kClosed);
  EXPECT_EQ(refutation_.size(), 1002U);
}

TEST_F(TableauTest, Stop_IsObeyed) {
  const auto clauses = Read("cnf(a,axiom, p(X) | ~ p(f(X)) | ~ p(g(X))). cnf(b,axiom, ~ p(a)).");
  Matrix matrix(clauses, {});
  int asked = 0;
  Tableau tableau(matrix, {}, kMemory, [&] { return ++asked == 2; });
  EXPECT_EQ(tableau.Search(), TableauEnd::kStopped);
  EXPECT_EQ(asked, 2);
}

TEST_F(TableauTest, Memory_IsRespected) {
  const auto clauses = Read("cnf(a,axiom, p(X) | ~ p(f(X))). cnf(b,axiom, ~ p(a)).");
  Matrix matrix(clauses, {});
  Tableau tableau(matrix, {}, 1, [] { return false; });
  EXPECT_EQ(tableau.Search(), TableauEnd::kMemory);
}

TEST_F(TableauTest, RandomGroundClauses_AgreeWithTruthTables) {
  constexpr int kSets = 2000;
  constexpr std::uint64_t kAtoms = 5;
  std::mt19937_64 random(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same sets every time
  const auto below = [&](std::uint64_t count) { return random() % count; };
  std::vector<logic::Atom> atoms;
  for (std::uint64_t i = 0; i < kAtoms; ++i) {
    atoms.emplace_back(symbols_.Intern("p" + std::to_string(i)));
  }
  const std::vector<Strategy> strategies = AllStrategies();
  int refuted = 0;
  for (int set = 0; set < kSets; ++set) {
    std::vector<Clause> clauses(4 + below(12));
    std::vector<std::vector<logic::Literal>> literals;
    for (Clause& clause : clauses) {
      const std::uint64_t size = 1 + below(3);
      for (std::uint64_t i = 0; i < size; ++i) {
        clause.literals.push_back({below(2) == 0, atoms[below(kAtoms)]});
      }
      literals.push_back(clause.literals);
    }
    const bool contradictory = Contradictory(literals);
    const Strategy& strategy = strategies[below(strategies.size())];
    const TableauEnd end = Search(clauses, strategy);
    if (contradictory) {
      EXPECT_TRUE(end == TableauEnd::kClosed || end == TableauEnd::kGaveUp);
      if (strategy.cut == Cut::kNone) {
        EXPECT_EQ(end, TableauEnd::kClosed);
      }
    } else {
      EXPECT_NE(end, TableauEnd::kClosed);
    }
    if (end == TableauEnd::kClosed) {
      ++refuted;
      EXPECT_TRUE(Contradictory(LiteralsOf(refutation_)));
    }
  }
  EXPECT_GT(refuted, kSets / 10);
}

}  // namespace
}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
// The procedure for layered theories, and the search for layered models, against Definition 1
// evaluated word by word, on random layered theories.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "reasoners/circumscription/formats/lay_file.h"
#include "reasoners/circumscription/layered/layered_models.h"
#include "reasoners/circumscription/layered/procedure.h"
#include "tests/reasoners/circumscription/layered_oracle.h"
#include "tests/reasoners/circumscription/random_layers.h"

namespace latchwork::circumscription {
namespace {

/// A random layered theory, its queries, and what Definition 1 says.
struct Sample {
  explicit Sample(std::uint64_t seed)
      : dice(seed), theory(RandomLayers(dice)), queries(LayeredQueries(dice, theory)) {
    const LayeredOracle oracle(theory);
    has_model = oracle.HasModel();
    for (const Clause& query : queries) definition.push_back(oracle.Entails(0, query));
    for (std::size_t layer = 1; layer < theory.layers.size(); ++layer) {
      for (const Bridge& bridge : theory.layers[layer - 1].bridges) {
        const Literal fails = -bridge.goal;
        goals_decided = goals_decided && (oracle.Entails(layer, {&bridge.goal, 1}) ||
                                          oracle.Entails(layer, {&fails, 1}));
      }
    }
    lower_definite = std::all_of(theory.layers.begin(), theory.layers.end() - 1, IsDefinite);
  }

  Dice dice;
  LayeredTheory theory;
  std::vector<Clause> queries;
  std::vector<bool> definition;
  bool has_model = false;
  bool goals_decided = true;
  bool lower_definite = false;
};

void Check(std::uint64_t seed) {
  const Sample sample(seed);
  SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + WriteLay(sample.theory, {}));
  LayeredModels models(sample.theory);
  ASSERT_EQ(models.HasModel() == Verdict::kYes, sample.has_model);
  Procedure single(sample.theory, Transfer::kSingle);
  Procedure open(sample.theory, Transfer::kOpen);
  Procedure refined(sample.theory, Transfer::kRefined);
  for (std::size_t i = 0; i < sample.queries.size(); ++i) {
    const Clause& query = sample.queries[i];
    SCOPED_TRACE(ToString(sample.theory.layers.front().theory, query));
    const bool definition = sample.definition[i];
    ASSERT_EQ(models.Entails(query).verdict == Verdict::kYes, definition);
    const bool by_single = single.Entails(query).verdict == Verdict::kYes;
    const bool by_open = open.Entails(query).verdict == Verdict::kYes;
    const bool by_refined = refined.Entails(query).verdict == Verdict::kYes;
    if (sample.has_model) {
      ASSERT_EQ(by_refined, definition);
    }
    if (sample.has_model && sample.goals_decided) {
      ASSERT_EQ(by_single, definition);
    }
    if (sample.lower_definite && query.size() == 1 && query[0] > 0 && by_single) {
      ASSERT_TRUE(definition);
    }
    ASSERT_LE(by_open, definition) << "open transfer concludes too much";
  }
}

class LayeredPropertyTest : public testing::TestWithParam<std::uint64_t> {};

TEST_P(LayeredPropertyTest, ProcedureMeansWhatDefinitionOneSays) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Check(1000 * GetParam() + i);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Thousands, LayeredPropertyTest, testing::Range<std::uint64_t>(0, 10));

/// What the assertions are about must occur, or they say nothing.
TEST(LayeredPropertySampleTest, AllCasesOccur) {
  int with_model = 0;
  int decided = 0;
  int definite = 0;
  int unsound = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Sample sample(seed);
    ASSERT_LE(LayeredOracle::AtomCount(sample.theory), 15U);
    with_model += sample.has_model ? 1 : 0;
    decided += sample.goals_decided ? 1 : 0;
    definite += sample.lower_definite ? 1 : 0;
    Procedure single(sample.theory, Transfer::kSingle);
    for (std::size_t i = 0; i < sample.queries.size(); ++i) {
      const bool concluded = single.Entails(sample.queries[i]).verdict == Verdict::kYes;
      unsound += concluded && !sample.definition[i] ? 1 : 0;
    }
  }
  EXPECT_GT(with_model, 600);
  EXPECT_GT(decided, 200);
  EXPECT_LT(decided, 950);
  EXPECT_GT(definite, 100);
  EXPECT_GT(unsound, 50) << "the paper's transfer is unsound where goals stay undecided";
}

/// Answers of the procedure whose engines may make `calls` SAT calls for a query.
std::vector<Verdict> Bounded(const Sample& sample, Transfer transfer, std::size_t calls) {
  ProcedureOptions options;
  options.engine.use_certificate = false;
  options.engine.calls = calls;
  Procedure procedure(sample.theory, transfer, options);
  std::vector<Verdict> verdicts;
  for (const Clause& query : sample.queries) {
    verdicts.push_back(procedure.Entails(query).verdict);
  }
  return verdicts;
}

TEST(LayeredBoundTest, WhatIsSaidWithinBoundsIsSaidWithoutThem) {
  constexpr std::size_t kEnough = 1000;
  std::size_t unknown_without_calls = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Sample sample(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + WriteLay(sample.theory, {}));
    for (const Transfer transfer : kTransfers) {
      const std::vector<Verdict> unbounded = Bounded(sample, transfer, kEnough);
      ASSERT_EQ(std::count(unbounded.begin(), unbounded.end(), Verdict::kUnknown), 0);
      for (const std::size_t calls : {0U, 1U, 2U, 3U, 4U, 6U, 8U}) {
        const std::vector<Verdict> bounded = Bounded(sample, transfer, calls);
        for (std::size_t i = 0; i < bounded.size(); ++i) {
          if (calls == 0 && bounded[i] == Verdict::kUnknown) ++unknown_without_calls;
          if (bounded[i] == Verdict::kUnknown) continue;
          ASSERT_EQ(bounded[i], unbounded[i]) << Name(transfer) << " with " << calls << " calls";
        }
      }
    }
  }
  EXPECT_GT(unknown_without_calls, 0U);
}

TEST(LayeredBoundTest, ManyStates_CountAsUndecided) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Sample sample(seed);
    ProcedureOptions options;
    options.max_states = 1;
    Procedure few(sample.theory, Transfer::kRefined, options);
    Procedure all(sample.theory, Transfer::kRefined);
    for (const Clause& query : sample.queries) {
      const Verdict verdict = few.Entails(query).verdict;
      if (verdict == Verdict::kUnknown) continue;
      ASSERT_EQ(verdict, all.Entails(query).verdict) << seed;
    }
  }
}

}  // namespace
}  // namespace latchwork::circumscription

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/unit_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <vector>

namespace latchwork::pttp {
namespace {

using Clauses = std::vector<PropositionalClause>;

PropositionalLiteral Positive(std::size_t atom) {
  return static_cast<PropositionalLiteral>(2 * atom);
}
PropositionalLiteral Negative(std::size_t atom) { return Positive(atom) + 1; }

/// Each pigeon in a hole, of which there is one less; no hole with two of them.
Clauses Pigeons(std::size_t pigeons) {
  const std::size_t holes = pigeons - 1;
  Clauses clauses(pigeons);
  for (std::size_t i = 0; i < pigeons * holes; ++i) clauses[i / holes].push_back(Positive(i));
  for (std::size_t i = 0; i < pigeons * holes; ++i) {
    for (std::size_t j = i + holes; j < pigeons * holes; j += holes) {
      clauses.push_back({Negative(i), Negative(j)});
    }
  }
  return clauses;
}

/// Whether the parents contradict the negated clause by unit propagation.
bool Propagates(const PropositionalClause& clause, const Clauses& parents) {
  std::set<PropositionalLiteral> untrue(clause.begin(), clause.end());
  const auto is_open = [&](PropositionalLiteral each) { return !untrue.contains(each); };
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (const PropositionalClause& parent : parents) {
      std::set<PropositionalLiteral> open;
      std::copy_if(parent.begin(), parent.end(), std::inserter(open, open.end()), is_open);
      if (open.empty()) return true;
      if (open.size() == 1) is_new = untrue.insert(*open.begin() ^ 1U).second || is_new;
    }
  }
  return false;
}

void ExpectSmallSteps(Clauses clauses, std::size_t most_parents, std::size_t most_steps) {
  const auto chain = UnitChain(clauses, {.parents = most_parents});
  ASSERT_TRUE(chain);
  EXPECT_LE(chain->size(), most_steps);
  for (const ChainStep& step : *chain) {
    EXPECT_LE(step.parents.size(), most_parents);
    Clauses parents;
    for (const std::size_t parent : step.parents) parents.push_back(clauses.at(parent));
    EXPECT_TRUE(Propagates(step.clause, parents));
    clauses.push_back(step.clause);
  }
  EXPECT_TRUE(clauses.back().empty());
}

TEST(UnitChainTest, Pigeons_HaveStepsOfFewParents) {
  for (const std::size_t pigeons : {2U, 3U, 4U, 5U, 6U})
    ExpectSmallSteps(Pigeons(pigeons), 16, 200);
}

TEST(UnitChainTest, LongConflict_IsBrokenUp) { ExpectSmallSteps(Pigeons(6), 8, 400); }

TEST(UnitChainTest, RulesAndFacts_HaveAStepForEachAtom) {
  constexpr std::size_t kAtoms = 300;
  Clauses clauses{{Positive(0)}, {Negative(kAtoms - 1)}};
  for (std::size_t i = 1; i < kAtoms; ++i) clauses.push_back({Negative(i - 1), Positive(i)});
  ExpectSmallSteps(clauses, 16, kAtoms);
}

TEST(UnitChainTest, WhatIsNotNeeded_HasNoSteps) {
  Clauses clauses = Pigeons(4);
  const std::size_t alone = UnitChain(clauses)->size();
  for (PropositionalLiteral i = 100; i < 140; i += 4) {
    clauses.insert(clauses.begin(), {{i}, {i ^ 1U, i + 2}});
  }
  EXPECT_EQ(UnitChain(clauses)->size(), alone);
}

TEST(UnitChainTest, EmptyPremise_IsEnough) {
  const auto chain = UnitChain({{Positive(0)}, {}});
  ASSERT_TRUE(chain);
  ASSERT_EQ(chain->size(), 1U);
  EXPECT_EQ(chain->front().parents, std::vector<std::size_t>{1});
}

TEST(UnitChainTest, RepeatedAndComplementaryLiterals_AreUnderstood) {
  ExpectSmallSteps({{Positive(0), Positive(0)},
                    {Positive(1), Negative(1)},
                    {Negative(0), Positive(2), Negative(0)},
                    {Negative(2)}},
                   16, 3);
}

TEST(UnitChainTest, ClausesWithAModel_HaveNone) {
  Clauses clauses = Pigeons(4);
  clauses.pop_back();
  EXPECT_FALSE(UnitChain(clauses));
}

TEST(UnitChainTest, TooManyConflicts_EndTheSearch) {
  EXPECT_FALSE(UnitChain(Pigeons(6), {.conflicts = 5}));
}

}  // namespace
}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
// The engine against the definition, on random theories.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reasoners/circumscription/engine/engine.h"
#include "tests/reasoners/circumscription/oracle.h"
#include "tests/reasoners/circumscription/random_theory.h"

namespace latchwork::circumscription {
namespace {

constexpr int kQueries = 6;

std::string Describe(const GroundTheory& theory, std::span<const Literal> latches) {
  std::string text;
  for (std::size_t i = 0; i < theory.atoms.size(); ++i) {
    const AtomInfo& atom = theory.atoms[i];
    text += std::to_string(i + 1) + (atom.role == Role::kFixed     ? ":Q "
                                     : atom.role == Role::kVarying ? ":Z "
                                                                   : ":P");
    if (atom.role == Role::kMinimized) text += std::to_string(atom.level) + " ";
  }
  for (const Clause& clause : theory.clauses) text += "\n  " + ToString(theory, clause);
  return text + "\n  latches " + ToString(theory, latches);
}

Verdict VerdictOf(bool yes) { return yes ? Verdict::kYes : Verdict::kNo; }

/// One engine, several cycles: what it learns in one must hold in the next.
void CompareWithOracle(std::uint64_t seed, int most_atoms, int cycles) {
  Dice dice(seed);
  const GroundTheory theory = RandomTheory(dice, most_atoms);
  EngineOptions options;
  options.use_certificate = seed % 4 != 0;
  Engine engine(theory, options);
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const std::vector<Literal> latches = RandomLatches(dice, theory);
    const Oracle oracle(theory, latches);
    engine.SetLatches(latches);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + Describe(theory, latches));
    ASSERT_EQ(engine.IsInconsistent().verdict, VerdictOf(oracle.models().empty()));
    for (int i = 0; i < kQueries; ++i) {
      const std::vector<Literal> query = RandomLiterals(dice, theory, i < 3 ? 1 : 4);
      SCOPED_TRACE(ToString(theory, query));
      ASSERT_EQ(engine.EntailsAlways(query).verdict, VerdictOf(oracle.EntailsAlways(query)));
      ASSERT_EQ(engine.HoldsSomewhere(query).verdict, VerdictOf(oracle.HoldsSomewhere(query)));
    }
  }
}

/// A counter-model is a minimal model by the definition, and has the atom false.
void CheckCounterModels(std::uint64_t seed) {
  Dice dice(seed);
  const GroundTheory theory = RandomTheory(dice, 10);
  const std::vector<Literal> latches = RandomLatches(dice, theory);
  EngineOptions options;
  options.use_certificate = seed % 2 != 0;
  Engine engine(theory, options);
  engine.SetLatches(latches);
  const Oracle oracle(theory, latches);
  SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + Describe(theory, latches));
  for (Atom atom = 1; atom <= static_cast<Atom>(theory.atoms.size()); ++atom) {
    const std::optional<Model> model = engine.CounterModel(atom);
    ASSERT_EQ(model.has_value(), !oracle.EntailsAlways({&atom, 1})) << atom;
    if (!model) continue;
    Oracle::World world = 0;
    for (Atom each = 1; each <= static_cast<Atom>(model->size()); ++each) {
      if (model->Holds(each)) world |= 1U << static_cast<unsigned>(each - 1);
    }
    EXPECT_FALSE(HoldsIn(world, atom));
    EXPECT_NE(std::find(oracle.minimal().begin(), oracle.minimal().end(), world),
              oracle.minimal().end());
  }
}

TEST(EngineCounterModelTest, IsAMinimalModelWithoutTheAtom) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    CheckCounterModels(seed);
    if (HasFatalFailure()) return;
  }
}

class EngineOracleTest : public testing::TestWithParam<std::uint64_t> {};

TEST_P(EngineOracleTest, AnswersAsTheDefinitionDoes) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    CompareWithOracle(1000 * GetParam() + i, 14, 2);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Thousands, EngineOracleTest, testing::Range<std::uint64_t>(0, 20));

}  // namespace
}  // namespace latchwork::circumscription

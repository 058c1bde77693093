// SPDX-License-Identifier: BSD-3-Clause
// Laws of one layer under what may be handed down to it, on random layered theories.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "reasoners/circumscription/engine/engine.h"
#include "reasoners/circumscription/engine/minimal_core.h"
#include "reasoners/circumscription/formats/lay_file.h"
#include "reasoners/circumscription/layered/layered_theory.h"
#include "tests/reasoners/circumscription/oracle.h"
#include "tests/reasoners/circumscription/random_layers.h"

namespace latchwork::circumscription {
namespace {

/// The lowest layer of a random layered theory; what is above is played by the dice.
class Lowest {
 public:
  explicit Lowest(std::uint64_t seed)
      : dice(seed), layers(RandomLayers(dice)), bridged(WithBridges(layers, 0)) {}

  /// The facts, and some premises with values.
  std::vector<Literal> Latches(bool all) {
    std::vector<Literal> latches = bridged.latches;
    for (const Atom premise : bridged.premises) {
      if (all || dice.Roll(2) == 0) latches.push_back(dice.Roll(2) == 0 ? premise : -premise);
    }
    return latches;
  }
  Atom atoms() const { return static_cast<Atom>(layers.layers.front().theory.atoms.size()); }

  Dice dice;
  LayeredTheory layers;
  BridgedTheory bridged;
};

template <typename Law>
void ForEachLayer(const Law& law) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Lowest lowest(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + WriteLay(lowest.layers, {}));
    law(lowest);
    if (testing::Test::HasFatalFailure()) return;
  }
}

bool IsForced(const GroundTheory& theory, std::vector<Literal> latches, Literal literal) {
  latches.push_back(-literal);
  return MinimalCore(theory, latches).has_value();
}

void KeepsWhatIsForced(Lowest& lowest) {
  const std::vector<Literal> few = lowest.Latches(false);
  std::vector<Literal> more = few;
  const std::vector<Literal> added = lowest.Latches(false);
  more.insert(more.end(), added.begin(), added.end());
  Engine engine(lowest.bridged.theory);
  engine.SetLatches(more);
  for (Atom atom = 1; atom <= lowest.atoms(); ++atom) {
    for (const Literal literal : {atom, -atom}) {
      if (!IsForced(lowest.bridged.theory, few, literal)) continue;
      ASSERT_TRUE(IsForced(lowest.bridged.theory, more, literal));
      ASSERT_EQ(engine.EntailsAlways({&literal, 1}).verdict, Verdict::kYes);
    }
  }
}

TEST(LayeredLawsTest, LatchesNeverTakeAwayWhatIsForced) { ForEachLayer(KeepsWhatIsForced); }

bool HasModel(const GroundTheory& theory, const Core& core, std::size_t left_out) {
  GroundTheory part;
  part.atoms = theory.atoms;
  std::size_t at = 0;
  for (const Literal latch : core.latches) {
    if (at++ != left_out) part.clauses.push_back({latch});
  }
  for (const std::size_t clause : core.clauses) {
    if (at++ != left_out) part.clauses.push_back(theory.clauses[clause]);
  }
  return !Oracle(part).models().empty();
}

void ExplainsMinimally(Lowest& lowest) {
  const GroundTheory& theory = lowest.bridged.theory;
  const std::vector<Literal> latches = lowest.Latches(true);
  for (Atom atom = 1; atom <= lowest.atoms(); ++atom) {
    std::vector<Literal> denied = latches;
    denied.push_back(-atom);
    const auto core = MinimalCore(theory, denied);
    ASSERT_EQ(core.has_value(), Oracle(theory, denied).models().empty());
    if (!core) continue;
    const std::size_t parts = core->latches.size() + core->clauses.size();
    ASSERT_FALSE(HasModel(theory, *core, parts)) << "does not re-prove " << atom;
    for (std::size_t i = 0; i < parts; ++i) {
      ASSERT_TRUE(HasModel(theory, *core, i)) << "part " << i << " is not needed for " << atom;
    }
  }
}

TEST(LayeredLawsTest, ExplanationsReproveAndAreMinimal) { ForEachLayer(ExplainsMinimally); }

using Pattern = std::uint32_t;

std::vector<Literal> AbnormalAsIn(const BridgedTheory& bridged, Pattern pattern) {
  std::vector<Literal> literals;
  for (std::size_t i = 0; i < bridged.abnormal.size(); ++i) {
    const bool holds = (pattern >> i & 1U) != 0;
    literals.push_back(holds ? bridged.abnormal[i] : -bridged.abnormal[i]);
  }
  return literals;
}

/// With every fixed atom known, bridges are given up only where the layer contradicts them, and
/// then as few as can be.
void GivesUpAsFewAsCanBe(Lowest& lowest) {
  std::vector<Literal> latches = lowest.Latches(true);
  for (Atom atom = 1; atom <= lowest.atoms(); ++atom) {
    if (lowest.bridged.theory.at(atom).role != Role::kFixed) continue;
    latches.push_back(lowest.dice.Roll(2) == 0 ? atom : -atom);
  }
  Engine engine(lowest.bridged.theory);
  engine.SetLatches(latches);
  const Pattern patterns = Pattern{1} << lowest.bridged.abnormal.size();
  std::vector<Pattern> minimal;
  for (Pattern pattern = 0; pattern < patterns; ++pattern) {
    const std::vector<Literal> abnormal = AbnormalAsIn(lowest.bridged, pattern);
    std::vector<Literal> all = latches;
    all.insert(all.end(), abnormal.begin(), abnormal.end());
    bool is_minimal = !Oracle(lowest.bridged.theory, all).models().empty();
    for (const Pattern other : minimal) is_minimal = is_minimal && (other & ~pattern) != 0;
    if (is_minimal) minimal.push_back(pattern);
    ASSERT_EQ(engine.HoldsSomewhere(abnormal).verdict == Verdict::kYes, is_minimal)
        << "bridges given up: " << pattern;
  }
}

TEST(LayeredLawsTest, BridgesAreGivenUpOnlyInConflictAndAsFewAsCanBe) {
  ForEachLayer(GivesUpAsFewAsCanBe);
}

void AnswersAsAFreshEngine(Lowest& lowest) {
  Engine warm(lowest.bridged.theory);
  for (int cycle = 0; cycle < 6; ++cycle) {
    const std::vector<Literal> latches = lowest.Latches(cycle % 2 == 0);
    warm.SetLatches(latches);
    Engine fresh(lowest.bridged.theory);
    fresh.SetLatches(latches);
    for (Atom atom = 1; atom <= lowest.atoms(); ++atom) {
      for (const Literal literal : {atom, -atom}) {
        ASSERT_EQ(warm.EntailsAlways({&literal, 1}).verdict,
                  fresh.EntailsAlways({&literal, 1}).verdict)
            << "cycle " << cycle << ", literal " << literal;
      }
    }
  }
}

TEST(LayeredLawsTest, WarmEngineAnswersAsAFreshOne) { ForEachLayer(AnswersAsAFreshEngine); }

}  // namespace
}  // namespace latchwork::circumscription

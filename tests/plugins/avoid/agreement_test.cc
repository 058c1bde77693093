// SPDX-License-Identifier: BSD-3-Clause
//
// The program and the theory conclude the same.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "latchwork/sdk/random.h"
#include "tests/plugins/layer_mind.h"

namespace latchwork::test {
namespace {

constexpr int kSonars = 8;

std::vector<std::string> Robot() {
  std::vector<std::string> facts = {"robot_radius(0.25)"};
  for (int i = 0; i < kSonars; ++i) {
    facts.push_back(fmt::format("sonar_direction({}, {:.6f})", i, 0.785 * (i - 3.5)));
  }
  return facts;
}

std::vector<std::string> Echoes(const sdk::RandomStream& random, std::uint64_t situation) {
  std::vector<std::string> facts;
  for (std::uint64_t i = 0; i < kSonars; ++i) {
    const double gap = random.Between(0.05, 3.5, situation, i);
    facts.push_back(gap > 3 ? fmt::format("no_echo({})", i)
                            : fmt::format("sonar_reading({}, {:.4f})", i, gap));
  }
  return facts;
}

std::vector<std::string> Objects(const sdk::RandomStream& random, std::uint64_t situation) {
  std::vector<std::string> facts;
  for (std::uint64_t i = random.Index(3, situation, 100); i > 0; --i) {
    facts.push_back(fmt::format("object(o{})", i));
    facts.push_back(
        fmt::format("distance(o{}, {:.4f})", i, random.Between(0.3, 2, situation, 100 + i)));
    facts.push_back(
        fmt::format("direction(o{}, {:.4f})", i, random.Between(-3.1, 3.1, situation, 200 + i)));
  }
  return facts;
}

/// Names and numbers of conclusions; the order in which forces are added may show in last digits.
std::vector<std::string> Rounded(LayerMind& mind) {
  mind.Cycle();
  std::vector<std::string> texts;
  for (const auto& conclusion : mind.decision().conclusions) {
    std::string text(conclusion.fact.predicate().name());
    for (const logic::Term& term : conclusion.fact.arguments()) {
      text += fmt::format(" {:.6f}", term.number());
    }
    texts.push_back(text);
  }
  return texts;
}

TEST(AvoidAgreementTest, ProgramAndTheory_ConcludeTheSame) {
  LayerMind theory("avoid");
  LayerMind program("avoid", {}, kIcarusMind);
  theory.Latch("robot", Robot());
  program.Latch("robot", Robot());
  const sdk::RandomStream random(3, "situations");
  std::size_t moving = 0;
  for (std::uint64_t situation = 0; situation < 300; ++situation) {
    const auto echoes = Echoes(random, situation);
    const auto objects = Objects(random, situation);
    for (LayerMind* mind : {&theory, &program}) {
      mind->Latch("sonar", echoes);
      mind->Latch("objects", objects);
    }
    const auto expected = Rounded(theory);
    EXPECT_EQ(Rounded(program), expected) << "situation " << situation;
    if (expected.size() > 1) ++moving;
  }
  EXPECT_GT(moving, 50U);
}

}  // namespace
}  // namespace latchwork::test

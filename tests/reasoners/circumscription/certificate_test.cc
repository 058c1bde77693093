// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/certificate/certificate.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/reasoners/circumscription/oracle.h"
#include "tests/reasoners/circumscription/random_theory.h"
#include "tests/reasoners/circumscription/robot_theory.h"

namespace latchwork::circumscription {
namespace {

std::vector<Literal> KnownLatches(Dice& dice, const GroundTheory& theory) {
  std::vector<Literal> latches;
  for (std::size_t i = 0; i < theory.atoms.size(); ++i) {
    const auto atom = static_cast<Atom>(i + 1);
    if (theory.atoms[i].role == Role::kFixed) latches.push_back(dice.Roll(2) == 0 ? atom : -atom);
  }
  return latches;
}

TEST(CertificateTest, SatisfiableDefiniteTheories_AlwaysClose) {
  Dice dice(11);
  int satisfiable = 0;
  for (int i = 0; i < 2000; ++i) {
    GroundTheory theory = RandomTheory(dice, 12);
    for (Clause& clause : theory.clauses) {
      for (std::size_t k = 1; k < clause.size(); ++k) clause[k] = -AtomOf(clause[k]);
    }
    const std::vector<Literal> latches = KnownLatches(dice, theory);
    const CompiledTheory compiled(theory);
    const bool has_model = !Oracle(theory, latches).models().empty();
    satisfiable += has_model ? 1 : 0;
    EXPECT_EQ(Certificate(compiled).Close(latches), has_model);
  }
  EXPECT_GT(satisfiable, 500);
}

TEST(CertificateTest, OpenFixedAtoms_DoNotClose) {
  GroundTheory theory;
  theory.Add({Role::kFixed, 1, ""});
  const CompiledTheory compiled(theory);
  Certificate certificate(compiled);
  EXPECT_FALSE(certificate.Close({}));
  const std::vector<Literal> latches = {-1};
  EXPECT_TRUE(certificate.Close(latches));
  EXPECT_TRUE(certificate.Holds(-1));
}

TEST(CertificateTest, ChosenVaryingAtoms_AreNotDetermined) {
  GroundTheory theory;
  const Atom chosen = theory.Add({Role::kVarying, 1, ""});
  const Atom forced = theory.Add({Role::kVarying, 1, ""});
  theory.clauses = {{forced}};
  const CompiledTheory compiled(theory);
  Certificate certificate(compiled);
  ASSERT_TRUE(certificate.Close({}));
  const std::vector<Literal> open = {-chosen};
  const std::vector<Literal> known = {forced};
  const std::vector<Literal> against = {chosen};
  EXPECT_EQ(certificate.SatisfiesAll(open), std::nullopt);
  EXPECT_EQ(certificate.SatisfiesAll(known), true);
  EXPECT_EQ(certificate.SatisfiesAll(against), false);
}

TEST(CertificateTest, RobotWithoutSuspects_AlwaysCloses) {
  const RobotTheory robot(24);
  EXPECT_EQ(robot.theory.atoms.size(), 258U);
  EXPECT_EQ(robot.theory.clauses.size(), 297U);
  EXPECT_EQ(robot.queries.size(), 20U);
  const CompiledTheory compiled(robot.theory);
  Certificate certificate(compiled);
  Dice dice(3);
  for (int i = 0; i < 200; ++i) EXPECT_TRUE(certificate.Close(robot.Latches(dice, 0)));
}

}  // namespace
}  // namespace latchwork::circumscription

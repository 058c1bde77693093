// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/policies/policy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/reasoners/circumscription/oracle.h"
#include "tests/reasoners/circumscription/random_theory.h"

namespace latchwork::circumscription {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class PolicyTest : public testing::Test {
 protected:
  PolicyTest() {
    theory_.Add({Role::kMinimized, 1, "a"});
    theory_.Add({Role::kMinimized, 1, "b"});
    theory_.clauses = {{1, 2}};
  }
  Verdict Entails(Policy policy, std::vector<Literal> clause) {
    return ClosedWorld(theory_, {}, policy).EntailsAlways(clause).verdict;
  }

  GroundTheory theory_;
};

TEST_F(PolicyTest, Disjunction_TellsThePoliciesApart) {
  EXPECT_EQ(ClosedWorld(theory_, {}, Policy::kCwa).IsInconsistent().verdict, Verdict::kYes);
  EXPECT_EQ(Entails(Policy::kGcwa, {-1, -2}), Verdict::kNo);
  EXPECT_EQ(Entails(Policy::kEgcwa, {-1, -2}), Verdict::kYes);
  EXPECT_EQ(Entails(Policy::kEcwa, {-1, -2}), Verdict::kYes);
  EXPECT_THAT(ClosedWorld(theory_, {}, Policy::kCwa).closed(), ElementsAre(1, 2));
  EXPECT_THAT(ClosedWorld(theory_, {}, Policy::kGcwa).closed(), IsEmpty());
}

TEST_F(PolicyTest, Names_AreFoundAgain) {
  for (const Policy policy :
       {Policy::kCwa, Policy::kGcwa, Policy::kCcwa, Policy::kEgcwa, Policy::kEcwa}) {
    EXPECT_EQ(FindPolicy(Name(policy)), policy);
  }
  EXPECT_EQ(FindPolicy("owa"), std::nullopt);
}

GroundTheory Parallel(GroundTheory theory, bool minimize_all) {
  for (AtomInfo& atom : theory.atoms) {
    atom.level = 1;
    if (minimize_all) atom.role = Role::kMinimized;
  }
  return theory;
}

/// The minimized atoms that are false in all minimal models.
std::vector<Atom> FalseEverywhere(const GroundTheory& theory, std::span<const Literal> latches) {
  const Oracle oracle(theory, latches);
  std::vector<Atom> atoms;
  for (std::size_t i = 0; i < theory.atoms.size(); ++i) {
    const auto atom = static_cast<Atom>(i + 1);
    const std::vector<Literal> clause = {-atom};
    if (theory.atoms[i].role == Role::kMinimized && oracle.EntailsAlways(clause)) {
      atoms.push_back(atom);
    }
  }
  return atoms;
}

TEST_F(PolicyTest, RandomTheories_CloseAsDefined) {
  Dice dice(31);
  for (int i = 0; i < 1000; ++i) {
    const GroundTheory theory = RandomTheory(dice, 8);
    const std::vector<Literal> latches = RandomLatches(dice, theory);
    const std::vector<Literal> query = RandomLiterals(dice, theory, 3);
    EXPECT_EQ(ClosedWorld(theory, latches, Policy::kCcwa).closed(),
              FalseEverywhere(Parallel(theory, false), latches));
    EXPECT_EQ(ClosedWorld(theory, latches, Policy::kGcwa).closed(),
              FalseEverywhere(Parallel(theory, true), latches));
    const bool follows = Oracle(Parallel(theory, true), latches).EntailsAlways(query);
    EXPECT_EQ(ClosedWorld(theory, latches, Policy::kEgcwa).EntailsAlways(query).verdict,
              follows ? Verdict::kYes : Verdict::kNo);
  }
}

}  // namespace
}  // namespace latchwork::circumscription

// SPDX-License-Identifier: BSD-3-Clause
// Random planning domains, judged by trying every action in every state. LATCHWORK_DOMAINS says how
// many are tried.
#include "tests/reasoners/pttp/random_domain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::pttp {
namespace {

constexpr std::uint64_t kUsualDomains = 120;

std::uint64_t Domains() {
  const char* const wanted = std::getenv("LATCHWORK_DOMAINS");
  return wanted == nullptr ? kUsualDomains : std::strtoull(wanted, nullptr, 10);
}

/// The actions of a situation, the first one first.
std::vector<std::string> ActionsOf(const logic::Term& situation) {
  std::vector<std::string> actions;
  for (const logic::Term* term = &situation; term->kind() == logic::Term::Kind::kCompound;
       term = &term->arguments()[1]) {
    actions.push_back(ToString(term->arguments()[0]));
  }
  std::reverse(actions.begin(), actions.end());
  return actions;
}

/// Decides one goal of a domain with one more clause.
class DomainMind {
 public:
  DomainMind(const RandomDomain& domain, const std::string& clause, const char* goal,
             sdk::Goal::Answers answers)
      : mind_(domain.Theory() + clause) {
    for (const char* name : {"p", "q", "e"}) mind_.Input(name, 2);
    for (const char* name : {"h", "m", "n"}) mind_.Input(name, 1);
    mind_.Input("r", 3);
    mind_.Minimize("n", 1);
    mind_.Goal(goal, answers);
    mind_.Load();
    mind_.budget.inferences = 20'000;
    mind_.Decide();
  }
  sdk::Status status() const { return mind_.decision.status; }
  const logic::Fact& fact() const { return mind_.decision.conclusions.at(0).fact; }
  std::set<std::string> facts() const {
    const auto conclusions = mind_.Conclusions();
    return {conclusions.begin(), conclusions.end()};
  }

 private:
  AgentMind mind_;
};

constexpr sdk::Status StatusOf(bool holds) {
  return holds ? sdk::Status::kProved : sdk::Status::kRefuted;
}

TEST(RandomDomainTest, PlansAreValidAndShortest) {
  std::size_t longest = 0;
  for (std::uint64_t number = 0; number < Domains(); ++number) {
    SCOPED_TRACE(number);
    const RandomDomain domain(number);
    const DomainMind mind(domain,
                          "fof(plan, axiom, ![S] : ((" + domain.WantedText() + ") => plan(S))).",
                          "plan(S)", sdk::Goal::Answers::kFirst);
    const auto shortest = domain.ShortestPlan();
    ASSERT_EQ(mind.status(), StatusOf(shortest.has_value()))
        << domain.Theory() << domain.WantedText();
    if (!shortest) continue;
    const auto actions = ActionsOf(mind.fact().argument(0));
    EXPECT_EQ(actions.size(), *shortest) << domain.Theory() << ToString(mind.fact());
    EXPECT_TRUE(domain.IsPlan(actions)) << domain.Theory() << ToString(mind.fact());
    longest = std::max(longest, *shortest);
  }
  EXPECT_GE(longest, 4U);
}

TEST(RandomDomainTest, FirstStepsBeginShortestPlans) {
  for (std::uint64_t number = 0; number < Domains(); ++number) {
    SCOPED_TRACE(number);
    const RandomDomain domain(number);
    const auto shortest = domain.ShortestPlan();
    if (!shortest || *shortest == 0) continue;
    const DomainMind mind(domain,
                          "cnf(first, axiom, first(A, do(A, s0)))."
                          "cnf(later, axiom, first(A, do(B, S)) | ~ first(A, S))."
                          "fof(next, axiom, ![A, S] : ((" +
                              domain.WantedText() + " & first(A, S)) => next(A))).",
                          "next(A)", sdk::Goal::Answers::kFirst);
    ASSERT_EQ(mind.status(), sdk::Status::kProved) << domain.Theory();
    EXPECT_EQ(domain.FirstActions().count(ToString(mind.fact().argument(0))), 1U)
        << domain.Theory() << ToString(mind.fact());
  }
}

/// What looks at the way to a situation may need others than those kept; then search is as good as
/// it can.
TEST(RandomDomainTest, PlansThroughAnActionAreJudgedRightly) {
  std::size_t decided = 0;
  for (std::uint64_t number = 0; number < Domains(); ++number) {
    SCOPED_TRACE(number);
    const RandomDomain domain(number);
    const std::string action = domain.Actions()[number % domain.Actions().size()];
    const DomainMind mind(domain,
                          "cnf(with, axiom, with(A, do(A, S)))."
                          "cnf(with_too, axiom, with(A, do(B, S)) | ~ with(A, S))."
                          "fof(plan, axiom, ![S] : ((" +
                              domain.WantedText() + " & with(" + action + ", S)) => plan(S))).",
                          "plan(S)", sdk::Goal::Answers::kFirst);
    const auto shortest = domain.ShortestPlanWith(action);
    if (mind.status() == sdk::Status::kUnknown) continue;
    ++decided;
    ASSERT_EQ(mind.status(), StatusOf(shortest.has_value())) << domain.Theory() << action;
    if (!shortest) continue;
    const auto actions = ActionsOf(mind.fact().argument(0));
    EXPECT_TRUE(domain.IsPlan(actions)) << domain.Theory() << ToString(mind.fact());
    EXPECT_EQ(std::count(actions.begin(), actions.end(), action) > 0, true);
    if (domain.HasRulesWithin()) continue;
    EXPECT_EQ(actions.size(), *shortest) << domain.Theory() << domain.WantedText() << action;
  }
  EXPECT_GT(4 * decided, Domains());
}

TEST(RandomDomainTest, WhatHoldsTogetherIsFoundInFull) {
  for (std::uint64_t number = 0; number < Domains(); ++number) {
    SCOPED_TRACE(number);
    const RandomDomain domain(number);
    const DomainMind mind(domain,
                          "fof(pair, axiom, ![X, Y, S] : ((p(X, S) & q(Y, S)) => pair(X, Y))).",
                          "pair(X, Y)", sdk::Goal::Answers::kAll);
    EXPECT_EQ(mind.status(), StatusOf(!domain.Pairs().empty())) << domain.Theory();
    EXPECT_EQ(mind.facts(), domain.Pairs()) << domain.Theory();
  }
}

}  // namespace
}  // namespace latchwork::pttp

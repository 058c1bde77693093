// SPDX-License-Identifier: BSD-3-Clause
//
// Layers with several minimal worlds: what is concluded, left open, and named as a contradiction.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "tests/reasoners/circumscription/circumscribing_mind.h"
#include "tests/reasoners/circumscription/oracle.h"
#include "tests/reasoners/circumscription/random_theory.h"

namespace latchwork::circumscription {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Answers = sdk::Goal::Answers;
using State = sdk::Assumption::State;

std::vector<std::string> Undecided(const CircumscribingMind& mind) {
  std::vector<std::string> facts;
  for (const auto& each : mind.decision.undecided) facts.push_back(ToString(each.fact));
  return facts;
}

TEST(SearchTest, WhatAllMinimalWorldsShareIsConcluded) {
  CircumscribingMind mind(
      "fof(some, axiom, ! [M] : (move(M) => (push(left) | push(right)))).\n"
      "fof(slow, axiom, ! [D] : (push(D) => slow)).\n");
  mind.Input("move", 1);
  mind.Minimize("push", 1);
  mind.Goal("slow");
  mind.Goal("push(D)", Answers::kAll);
  mind.Parameter("mode", "exact");
  mind.Load();
  mind.Latch(0, {"move(on)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kUnknown);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("slow"));
  EXPECT_THAT(Undecided(mind), ElementsAre("push(left)", "push(right)"));
  EXPECT_THAT(mind.decision.states, ElementsAre(ElementsAre(0U), ElementsAre(1U)));
  mind.Latch(0, {});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
  EXPECT_THAT(Undecided(mind), IsEmpty());
}

constexpr const char* kBirds =
    "fof(birds, axiom, ! [X] : ((bird(X) & ~ abnormal(X)) => flies(X))).\n"
    "fof(penguins, axiom, ! [X] : ~ (penguin(X) & flies(X))).\n";

void LoadBirds(CircumscribingMind& mind) {
  mind.Input("bird", 1);
  mind.Input("penguin", 1);
  mind.Minimize("abnormal", 1);
  mind.Goal("flies(X)", Answers::kAll);
  mind.Goal("abnormal(X)", Answers::kAll);
  mind.Parameter("mode", "exact");
  mind.Load();
}

TEST(SearchTest, HardClausesRetractDefaults) {
  CircumscribingMind mind(kBirds);
  LoadBirds(mind);
  mind.Latch(0, {"bird(opus)", "bird(tweety)", "penguin(opus)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ElementsAre("flies(tweety)", "abnormal(opus)"));
  ASSERT_EQ(mind.decision.assumptions.size(), 2U);
  EXPECT_EQ(mind.decision.assumptions[0].state, State::kRetracted);
  EXPECT_EQ(mind.decision.assumptions[1].state, State::kMade);
  EXPECT_EQ(ToString(mind.decision.assumptions[1].atom), "abnormal(tweety)");
  EXPECT_THAT(mind.decision.conclusions[0].assumptions, ElementsAre(1U));
  EXPECT_THAT(mind.decision.conclusions[1].assumptions, IsEmpty());
  EXPECT_EQ(mind.reasoner.Explain(0).steps.back().conclusion, "flies(tweety)");
}

TEST(SearchTest, ChangedLatchesChangeTheWorldsBackAndForth) {
  CircumscribingMind mind(kBirds);
  LoadBirds(mind);
  for (int cycle = 0; cycle < 4; ++cycle) {
    mind.Latch(0, {"bird(opus)", "penguin(opus)"});
    mind.Decide();
    EXPECT_THAT(mind.Conclusions(), ElementsAre("abnormal(opus)"));
    mind.Latch(0, {"bird(opus)"});
    mind.Decide();
    EXPECT_THAT(mind.Conclusions(), ElementsAre("flies(opus)"));
  }
}

TEST(SearchTest, ContradictionsHaveALeastCore) {
  CircumscribingMind mind(
      "fof(a, axiom, ! [X] : (seen(X) => there(X))).\n"
      "fof(b, axiom, ! [X] : (there(X) => solid(X))).\n"
      "fof(c, axiom, ! [X] : ~ (solid(X) & ghost(X))).\n"
      "fof(d, axiom, ! [X] : (solid(X) => heavy(X))).\n");
  mind.Input("seen", 1);
  mind.Input("ghost", 1);
  mind.Goal("heavy(X)");
  mind.Parameter("mode", "exact");
  mind.Load();
  mind.Latch(0, {"seen(box)", "ghost(box)", "seen(wall)", "ghost(bob)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kInconsistent);
  EXPECT_THAT(mind.decision.message, HasSubstr("clauses 'a', 'b', 'c' with seen(box), ghost(box)"));
  EXPECT_THAT(mind.Conclusions(), IsEmpty());
}

/// The way is safe, or six pigeons are in five holes: to see that they are not takes a search.
std::string Pigeons() {
  std::string text =
      "fof(way, axiom, trapped | safe).\n"
      "fof(go, axiom, safe => go).\n"
      "fof(one, axiom, ! [P, Q, H] : ~ (in(P, H) & in(Q, H) & less(P, Q))).\n"
      "fof(some, axiom, ! [P] : ((trapped & pigeon(P)) => (";
  for (int hole = 0; hole < 5; ++hole) text += fmt::format("{}in(P, h{})", hole ? " | " : "", hole);
  text += "))).\n";
  for (int p = 0; p < 6; ++p) {
    text += fmt::format("fof(p, axiom, pigeon(p{})).\n", p);
    for (int q = p + 1; q < 6; ++q) text += fmt::format("fof(l, axiom, less(p{}, p{})).\n", p, q);
  }
  return text;
}

class SearchBudgetTest : public ::testing::TestWithParam<const char*> {
 protected:
  void Load(CircumscribingMind& mind) {
    mind.Goal("go");
    mind.Parameter("mode", "exact");
    mind.Parameter("entailment", GetParam());
    mind.Load();
  }
};

TEST_P(SearchBudgetTest, InferencesAreCountedInSearch) {
  CircumscribingMind mind(Pigeons());
  Load(mind);
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  const std::uint64_t needed = mind.decision.statistics.inferences;
  EXPECT_EQ(mind.decision.limit, sdk::Limit::kNone);
  CircumscribingMind again(Pigeons());
  Load(again);
  again.budget.inferences = needed + 1;
  EXPECT_EQ(again.Decide().status, sdk::Status::kProved);
  EXPECT_EQ(again.decision.statistics.inferences, needed);
  CircumscribingMind poor(Pigeons());
  Load(poor);
  poor.budget.inferences = needed - 1;
  EXPECT_EQ(poor.Decide().status, sdk::Status::kUnknown);
  EXPECT_EQ(poor.decision.limit, sdk::Limit::kInferences);
  EXPECT_EQ(poor.decision.statistics.inferences, needed - 1);
  poor.budget = {};
  EXPECT_EQ(poor.Decide().status, sdk::Status::kProved);
  EXPECT_EQ(poor.decision.limit, sdk::Limit::kNone);
}

TEST_P(SearchBudgetTest, CancellingEndsTheSearch) {
  CircumscribingMind mind(Pigeons());
  Load(mind);
  const std::atomic<bool> cancelled = true;
  mind.budget.cancelled = &cancelled;
  EXPECT_EQ(mind.Decide().status, sdk::Status::kUnknown);
  EXPECT_EQ(mind.decision.limit, sdk::Limit::kCancelled);
}

TEST_P(SearchBudgetTest, TheDeadlineEndsTheSearch) {
  CircumscribingMind mind(Pigeons());
  Load(mind);
  mind.budget.deadline = std::chrono::steady_clock::time_point::min();
  EXPECT_EQ(mind.Decide().status, sdk::Status::kUnknown);
  EXPECT_EQ(mind.decision.limit, sdk::Limit::kTime);
  const std::uint64_t grounding = mind.decision.statistics.inferences;
  EXPECT_LT(grounding, 1024U) << "so that evaluation does not look at the clock itself";
  mind.budget = {};
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_GT(mind.decision.statistics.inferences, grounding);
}

INSTANTIATE_TEST_SUITE_P(Entailments, SearchBudgetTest, ::testing::Values("cautious", "brave"),
                         [](const auto& each) { return std::string(each.param); });

TEST(SearchTest, PrioritiesDecideWhichDefaultYields) {
  const char* const theory =
      "fof(one, axiom, (~ ab1 & on) => go).\n"
      "fof(two, axiom, (~ ab2 & on) => ~ go).\n";
  for (const bool first : {true, false}) {
    CircumscribingMind mind(theory);
    mind.Input("on", 0);
    mind.body.minimized = {{mind.Name("ab1", 0), 0, first ? 1U : 2U},
                           {mind.Name("ab2", 0), 0, first ? 2U : 1U}};
    mind.Goal("go");
    mind.Parameter("mode", "exact");
    mind.Load();
    mind.Latch(0, {"on"});
    EXPECT_EQ(mind.Decide().status, first ? sdk::Status::kProved : sdk::Status::kRefuted);
  }
}

TEST(SearchTest, BraveConclusionsHoldInSomeWorld) {
  CircumscribingMind mind("fof(some, axiom, on => (a | b)).");
  mind.Input("on", 0);
  mind.Minimize("a", 0);
  mind.Minimize("b", 0);
  mind.Goal("a");
  mind.Goal("b");
  mind.Parameter("mode", "exact");
  mind.Parameter("entailment", "brave");
  mind.Load();
  mind.Latch(0, {"on"});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(), ElementsAre("a", "b"));
}

std::string Name(const GroundTheory& theory, Atom atom) {
  constexpr std::string_view kRoles = "pzq";
  return fmt::format("{}{}", kRoles[static_cast<std::size_t>(theory.at(atom).role)], atom);
}

/// The theory as a layer's: fixed atoms are fixed predicates, all others are goals.
void Load(CircumscribingMind& mind, const GroundTheory& theory) {
  std::string text;
  for (const Clause& clause : theory.clauses) {
    text += fmt::format("cnf(c{}, axiom, (", text.size());
    std::string_view separator;
    for (const Literal literal : clause) {
      text +=
          fmt::format("{}{}{}", separator, literal < 0 ? "~ " : "", Name(theory, AtomOf(literal)));
      separator = " | ";
    }
    text += clause.empty() ? "$false)).\n" : ")).\n";
  }
  // Every predicate must be stated by something.
  for (Atom atom = 1; atom <= static_cast<Atom>(theory.atoms.size()); ++atom) {
    const std::string name = Name(theory, atom);
    mind.Input(name, 0);
    const AtomInfo& info = theory.at(atom);
    if (info.role == Role::kMinimized) {
      mind.body.minimized.push_back(
          {mind.Name(name, 0), 0, static_cast<std::uint32_t>(info.level)});
    }
    if (info.role == Role::kFixed) mind.body.fixed.push_back(mind.Name(name, 0));
    if (info.role != Role::kFixed) mind.Goal(name);
  }
  mind.Write(text);
  mind.Parameter("mode", "exact");
  mind.Load();
}

std::vector<std::string> AtomsWhere(const GroundTheory& theory,
                                    const std::function<bool(Atom)>& holds) {
  std::vector<std::string> names;
  for (Atom atom = 1; atom <= static_cast<Atom>(theory.atoms.size()); ++atom) {
    if (theory.at(atom).role != Role::kFixed && holds(atom)) names.push_back(Name(theory, atom));
  }
  return names;
}

/// A layer minimizes what varies after all else, so that it is bravely concluded only where some
/// clause asks for it.
GroundTheory WithVaryingLast(GroundTheory theory) {
  int last = 1;
  for (const AtomInfo& atom : theory.atoms) last = std::max(last, atom.level + 1);
  for (AtomInfo& atom : theory.atoms) {
    if (atom.role == Role::kVarying) atom = {Role::kMinimized, last, atom.name};
  }
  return theory;
}

bool IsConcluded(const GroundTheory& theory, const Oracle& oracle, const Oracle& last, Atom atom,
                 bool is_brave) {
  if (!is_brave) return oracle.EntailsAlways({&atom, 1});
  const bool varies = theory.at(atom).role == Role::kVarying;
  return (varies ? last : oracle).HoldsSomewhere({&atom, 1});
}

/// Positive conclusions of minimized and varying atoms, straight from the definition: how many of
/// the random theories have a model.
int CompareWithDefinition(bool is_brave, int theories) {
  Dice dice(7);
  int consistent = 0;
  for (int i = 0; i < theories; ++i) {
    const GroundTheory theory = RandomTheory(dice, 8);
    CircumscribingMind mind;
    if (is_brave) mind.Parameter("entailment", "brave");
    Load(mind, theory);
    std::vector<Literal> latches;
    std::vector<std::string> facts;
    for (Atom atom = 1; atom <= static_cast<Atom>(theory.atoms.size()); ++atom) {
      if (theory.at(atom).role != Role::kFixed || dice.Roll(2) == 0) continue;
      latches.push_back(atom);
      facts.push_back(Name(theory, atom));
    }
    mind.Latch(0, facts);
    const Oracle oracle(theory, latches);
    const Oracle last(WithVaryingLast(theory), latches);
    mind.Decide();
    if (oracle.minimal().empty()) {
      EXPECT_EQ(mind.decision.status, sdk::Status::kInconsistent) << i;
      continue;
    }
    ++consistent;
    const auto expected = AtomsWhere(
        theory, [&](Atom atom) { return IsConcluded(theory, oracle, last, atom, is_brave); });
    EXPECT_EQ(mind.Conclusions(), expected) << i;
  }
  return consistent;
}

TEST(SearchTest, RandomLayersConcludeWhatTheDefinitionSays) {
  EXPECT_GT(CompareWithDefinition(false, 400), 200);
}

TEST(SearchTest, RandomBraveLayersConcludeWhatSomeMinimalModelHas) {
  EXPECT_GT(CompareWithDefinition(true, 1000), 500);
}

}  // namespace
}  // namespace latchwork::circumscription

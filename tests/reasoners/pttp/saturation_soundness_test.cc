// SPDX-License-Identifier: BSD-3-Clause
// Answers on random clause sets against truth tables, and steps of proofs against small
// interpretations: what holds where the parents hold.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "tests/reasoners/pttp/saturation_fixture.h"

namespace latchwork::pttp::saturation {
namespace {

constexpr std::size_t kAtoms = 6;

struct Propositional {
  std::string text;
  /// For each clause the atoms that occur positively and negatively, as bits.
  std::vector<std::array<unsigned, 2>> clauses;

  explicit Propositional(std::uint64_t number) {
    Draws draws(number);
    clauses.resize(4 + draws.Pick(16));
    for (auto& clause : clauses) {
      std::string literals;
      for (std::size_t size = 1 + draws.Pick(3); size > 0; --size) {
        const std::size_t atom = draws.Pick(kAtoms);
        const bool positive = draws.Pick(2) == 0;
        clause[positive ? 0 : 1] |= 1U << atom;
        literals += (literals.empty() ? "" : " | ") + std::string(positive ? "" : "~ ") + "p" +
                    std::to_string(atom);
      }
      text += "cnf(c, axiom, " + literals + ").\n";
    }
  }

  bool Satisfiable() const {
    for (unsigned world = 0; world < 1U << kAtoms; ++world) {
      bool all = true;
      for (const auto& [positive, negative] : clauses) {
        all = all && ((world & positive) != 0 || (~world & negative) != 0);
      }
      if (all) return true;
    }
    return false;
  }
};

TEST(SaturateSoundnessTest, RandomPropositional_AgreesWithTruthTables) {
  std::size_t refuted = 0;
  constexpr std::uint64_t kRounds = 4000;
  for (std::uint64_t round = 0; round < kRounds; ++round) {
    const Propositional problem(round);
    Options options;
    options.selection = static_cast<Selection>(round % 5);
    const Attempt run(problem.text, options);
    EXPECT_EQ(run.outcome.status, problem.Satisfiable() ? Status::kSaturated : Status::kRefuted)
        << problem.text;
    refuted += run.outcome.status == Status::kRefuted ? 1 : 0;
  }
  EXPECT_GT(refuted, kRounds / 10);
  EXPECT_LT(refuted, kRounds - kRounds / 10);
}

/// An interpretation over {0 .. size-1}, its tables filled at random as they are asked for.
class World {
 public:
  World(std::uint64_t number, std::size_t size) : draws_(number), size_(size) {}

  bool Holds(const logic::Clause& clause) {
    std::vector<std::size_t> values(clause.variable_names.size(), 0);
    for (;;) {
      if (!HoldsFor(clause, values)) return false;
      std::size_t i = 0;
      while (i < values.size() && ++values[i] == size_) values[i++] = 0;
      if (i == values.size()) return true;
    }
  }

 private:
  bool HoldsFor(const logic::Clause& clause, const std::vector<std::size_t>& values) {
    for (const logic::Literal& literal : clause.literals) {
      if (TruthOf(literal.atom, values) == literal.positive) return true;
    }
    return false;
  }
  bool TruthOf(const logic::Atom& atom, const std::vector<std::size_t>& values) {
    std::vector<std::size_t> arguments;
    for (const auto& term : atom.arguments()) arguments.push_back(ValueOf(term, values));
    if (atom.predicate().name() == "=") return arguments[0] == arguments[1];
    return LookUp("p" + std::string(atom.predicate().name()), arguments, 2) == 1;
  }
  std::size_t ValueOf(const logic::Term& term, const std::vector<std::size_t>& values) {
    if (term.is_variable()) return values[term.variable()];
    std::vector<std::size_t> arguments;
    for (const auto& argument : term.arguments()) arguments.push_back(ValueOf(argument, values));
    return LookUp("f" + std::string(term.symbol().name()), arguments, size_);
  }
  std::size_t LookUp(const std::string& name, const std::vector<std::size_t>& arguments,
                     std::size_t range) {
    const auto [at, is_new] = table_.try_emplace({name, arguments}, 0);
    if (is_new) at->second = draws_.Pick(range);
    return at->second;
  }

  Draws draws_;
  std::size_t size_;
  std::map<std::pair<std::string, std::vector<std::size_t>>, std::size_t> table_;
};

/// How often the parents of a derived step held and the step did, too.
std::size_t CheckSteps(const Outcome& outcome, std::uint64_t worlds) {
  std::size_t checked = 0;
  for (const Step& step : outcome.proof) {
    if (step.input) continue;
    for (std::uint64_t number = 0; number < worlds; ++number) {
      World world(number, 1 + number % 3);
      bool parents_hold = true;
      for (const std::size_t parent : step.parents) {
        parents_hold = parents_hold && world.Holds(outcome.proof[parent].clause);
      }
      if (!parents_hold) continue;
      ++checked;
      EXPECT_TRUE(world.Holds(step.clause)) << step.rule << " " << ToString(step.clause);
    }
  }
  return checked;
}

TEST(SaturateSoundnessTest, GroupProof_EveryStepFollowsFromItsParents) {
  const Attempt run(
      "cnf(a, axiom, m(e, X) = X).\ncnf(b, axiom, m(i(X), X) = e).\n"
      "cnf(c, axiom, m(m(X, Y), Z) = m(X, m(Y, Z))).\ncnf(d, axiom, m(a, i(a)) != e).\n");
  ASSERT_EQ(run.outcome.status, Status::kRefuted);
  EXPECT_TRUE(run.outcome.proof.back().clause.literals.empty());
  EXPECT_GT(CheckSteps(run.outcome, 200), 20U);
}

std::string RandomFirstOrder(std::uint64_t number) {
  Draws draws(number);
  static constexpr std::array<const char*, 7> kTerms{"a", "b", "X", "Y", "f(a)", "f(X)", "f(b)"};
  const auto term = [&] { return std::string(kTerms[draws.Pick(kTerms.size())]); };
  std::string text;
  for (std::size_t clauses = 4 + draws.Pick(4); clauses > 0; --clauses) {
    std::string literals;
    for (std::size_t size = 1 + draws.Pick(2); size > 0; --size) {
      const bool positive = draws.Pick(2) == 0;
      const std::string separator = literals.empty() ? "" : " | ";
      switch (draws.Pick(3)) {
        case 0:
          literals += separator + term() + (positive ? " = " : " != ") + term();
          break;
        case 1:
          literals += separator + (positive ? "p(" : "~ p(") + term() + ")";
          break;
        default:
          literals += separator + (positive ? "q(" : "~ q(") + term() + "," + term() + ")";
      }
    }
    text += "cnf(c" + std::to_string(clauses) + ", axiom, " + literals + ").\n";
  }
  return text;
}

TEST(SaturateSoundnessTest, RandomFirstOrder_SelectionsAgreeAndStepsFollow) {
  std::size_t refuted = 0;
  std::size_t saturated = 0;
  std::size_t checked = 0;
  for (std::uint64_t round = 0; round < 600; ++round) {
    const std::string text = RandomFirstOrder(round);
    std::vector<bool> seen(2, false);
    for (const auto selection :
         {Selection::kMaximal, Selection::kLargest, Selection::kUnlessUnique}) {
      Options options;
      options.selection = selection;
      options.precedence = static_cast<Precedence>(round % 3);
      options.max_inferences = 3000;
      const Attempt run(text, options);
      seen[0] = seen[0] || run.outcome.status == Status::kRefuted;
      seen[1] = seen[1] || run.outcome.status == Status::kSaturated;
      checked += CheckSteps(run.outcome, 12);
    }
    EXPECT_FALSE(seen[0] && seen[1]) << text;
    refuted += seen[0] ? 1 : 0;
    saturated += seen[1] ? 1 : 0;
  }
  EXPECT_GT(refuted, 100U);
  EXPECT_GT(saturated, 100U);
  EXPECT_GT(checked, 1000U);
}

TEST(SaturateSoundnessTest, RandomFirstOrder_WithSmallModel_IsNotRefuted) {
  std::size_t models = 0;
  for (std::uint64_t round = 0; round < 600; ++round) {
    Options options;
    options.max_inferences = 3000;
    const Attempt run(RandomFirstOrder(round), options);
    for (std::uint64_t number = 0; number < 40; ++number) {
      World world(number, 1 + number % 3);
      bool model = true;
      for (const auto& clause : run.clauses) model = model && world.Holds(clause);
      if (!model) continue;
      ++models;
      EXPECT_NE(run.outcome.status, Status::kRefuted) << RandomFirstOrder(round);
      break;
    }
  }
  EXPECT_GT(models, 30U);
}

}  // namespace
}  // namespace latchwork::pttp::saturation

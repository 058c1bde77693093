// SPDX-License-Identifier: BSD-3-Clause
//
// A traveller between places learns which way to take.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/sdk/random.h"
#include "reasoners/icarus/learning/value_learner.h"

namespace latchwork::icarus::testing {
namespace {

constexpr std::string_view kTraveller = R"(
(Travel () :requires ((at ?place)) :means ((Rest ?place) (Walk ?place)))
(Walk (?place) :means ((TakeRoad ?place) (TakePath ?place)))
(Rest (?place) :means ((Stay)))
(TakeRoad (?place) :means ((Go road)))
(TakePath (?place) :means ((Go path)))
(Stay () :action ({stay}))
(Go (?way) :action ({go ?way})))";

/// Five places in a row. Resting at the first pays a little, every step costs; the last place
/// pays well. From even places the road leads on, from odd ones the path; the other way leads
/// back to the first. Now and then the traveller gets nowhere.
class Journey {
 public:
  Journey(ValueLearner& learner, Interpreter& interpreter, NamePool& names, std::size_t top)
      : learner_(learner), interpreter_(interpreter), names_(names), top_(top) {}

  /// The rewards of one episode.
  double Run(std::uint64_t seed) {
    const sdk::RandomStream stream(seed, "journey");
    double sum = 0;
    std::int64_t place = 0;
    for (std::uint64_t step = 0; step < 20 && place < 4; ++step) {
      Arrive(place);
      learner_.BeginCycle();
      const CycleResult& result = interpreter_.Cycle(top_);
      clauses_ += result.clauses;
      const std::string act(names_.Name(result.acts[0].calls[0].function));
      const bool road =
          act == "go" && names_.Name(result.acts[0].calls[0].arguments[0].name) == "road";
      learner_.Choose(&result.acts[0]);
      double reward = 0;
      if (act == "stay") {
        reward = place == 0 ? 0.1 : -0.1;
      } else if (stream.Uniform(step) < 0.9) {
        place = road == (place % 2 == 0) ? place + 1 : 0;
        reward = place == 4 ? 10 : -0.2;
      }
      learner_.Reward(reward);
      sum += reward;
    }
    learner_.EndEpisode();
    return sum;
  }

  /// Evaluated since it was made.
  std::uint64_t clauses() const { return clauses_; }

 private:
  void Arrive(std::int64_t place) {
    Arena arena;
    for (const auto* fact = interpreter_.memory().First(); fact != nullptr; fact = fact->next) {
      if (fact->died == 0) interpreter_.memory().Remove(fact);
    }
    const std::array<Value, 2> fact = {Value::Symbol(names_.Intern("at")), Value::Integer(place)};
    interpreter_.memory().Store(arena.MakeList(fact));
  }

  ValueLearner& learner_;
  Interpreter& interpreter_;
  NamePool& names_;
  std::size_t top_;
  std::uint64_t clauses_ = 0;
};

class NoHost : public Host {
 public:
  std::span<const Signature> functions() const override { return {}; }
  Value Call(std::size_t /*function*/, std::span<const Value> /*arguments*/, Arena& /*arena*/,
             NamePool& /*names*/) override {
    return {};
  }
};

struct Traveller {
  explicit Traveller(const LearningOptions& learning, Expansion expansion = Expansion::kAll)
      : file(ReadProgram(std::string(kTraveller), "p.icarus")),
        learner(file.program, names, learning),
        interpreter(file.program, host, names, Options(expansion)),
        journey(learner, interpreter, names, interpreter.AddTop("(Travel)", findings)) {
    interpreter.SetValues(&learner);
  }
  static RunOptions Options(Expansion expansion) {
    RunOptions options;
    options.acts = ActMode::kValue;
    options.expansion = expansion;
    return options;
  }
  void Train(std::uint64_t episodes) {
    for (std::uint64_t i = 0; i < episodes; ++i) journey.Run(1000 + i);
  }
  std::vector<double> Play(std::uint64_t episodes) {
    learner.SetLearning(false);
    std::vector<double> sums;
    for (std::uint64_t i = 0; i < episodes; ++i) sums.push_back(journey.Run(i));
    learner.SetLearning(true);
    return sums;
  }

  ProgramFile file;
  NamePool names;
  NoHost host;
  Findings findings;
  ValueLearner learner;
  Interpreter interpreter;
  Journey journey;
};

/// The mean and its standard error.
std::pair<double, double> MeanAndError(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / (count * (count - 1)))};
}

LearningOptions Exploring() {
  LearningOptions options;
  options.exploration = 0.3;
  options.discount = 0.95;
  return options;
}

TEST(IcarusLearningTest, LearnedChoice_BeatsTheUnlearnedOverPairedSeeds) {
  for (const double trace : {0.0, 0.9}) {
    LearningOptions options = Exploring();
    options.trace = trace;
    Traveller learned(options);
    learned.Train(400);
    Traveller unlearned(options);
    const std::vector<double> with = learned.Play(30);
    const std::vector<double> without = unlearned.Play(30);
    std::vector<double> gains;
    for (std::size_t i = 0; i < with.size(); ++i) gains.push_back(with[i] - without[i]);
    const auto [mean, error] = MeanAndError(gains);
    EXPECT_GT(mean - 2 * error, 5) << "trace " << trace << ", mean " << mean;
    EXPECT_LT(mean + 2 * error, 10);
  }
}

TEST(IcarusLearningTest, Pruning_AsksOnlyTheMeansOfTheHighestEstimate) {
  Traveller learned(Exploring());
  learned.Train(400);
  Traveller pruned(Exploring(), Expansion::kBest);
  Findings findings;
  pruned.learner.Read(learned.learner.Write(), "values", findings);
  ASSERT_TRUE(findings.empty()) << Format(findings[0]);
  const std::uint64_t before = learned.journey.clauses();
  EXPECT_EQ(pruned.Play(20), learned.Play(20));
  // Of three means, which call an act each, one is asked.
  EXPECT_LT(pruned.journey.clauses(), learned.journey.clauses() - before);
}

TEST(IcarusLearningTest, SameSeed_LearnsTheSame) {
  Traveller one(Exploring());
  Traveller two(Exploring());
  one.Train(50);
  two.Train(50);
  EXPECT_EQ(one.learner.Write(), two.learner.Write());
  LearningOptions other = Exploring();
  other.seed = 2;
  Traveller three(other);
  three.Train(50);
  EXPECT_NE(one.learner.Write(), three.learner.Write());
}

/// Chooses `(Walk place)` for each place in turn, with its reward.
void Wander(Traveller& traveller, const std::vector<std::pair<int, double>>& steps) {
  Findings findings;
  for (const auto& [place, reward] : steps) {
    const std::size_t top =
        traveller.interpreter.AddTop("(Walk " + std::to_string(place) + ")", findings);
    traveller.learner.BeginCycle();
    traveller.learner.Choose(&traveller.interpreter.Cycle(top).acts[0]);
    traveller.learner.Reward(reward);
  }
  ASSERT_TRUE(findings.empty());
}

LearningOptions Halving(double trace) {
  LearningOptions options;
  options.exploration = 0;
  options.discount = 0.5;
  options.trace = trace;
  return options;
}

TEST(IcarusLearningTest, Credit_GoesToEverySkillOnThePath) {
  Traveller traveller(Halving(1));
  Wander(traveller, {{0, 2.0}, {1, 4.0}});
  traveller.learner.EndEpisode();
  EXPECT_EQ(traveller.learner.Write(),
            "(value (Go road) 4 1)\n(value (TakeRoad 0) 4 1)\n(value (TakeRoad 1) 4 1)\n"
            "(value (Walk 0) 4 1)\n(value (Walk 1) 4 1)\n");
}

TEST(IcarusLearningTest, Stay_IsOneChoiceHoweverManyCyclesItLasts) {
  for (const double trace : {0.0, 1.0}) {
    Traveller traveller(Halving(trace));
    Wander(traveller, {{0, 0.0}, {0, 0.0}, {0, 8.0}});
    traveller.learner.EndEpisode();
    Wander(traveller, {{0, 6.0}});
    traveller.learner.EndEpisode();
    EXPECT_EQ(traveller.learner.Write(),
              "(value (Go road) 4 2)\n(value (TakeRoad 0) 4 2)\n(value (Walk 0) 4 2)\n")
        << "2 for what came two cycles later, then 6; trace " << trace;
  }
}

TEST(IcarusLearningTest, Stay_ThatOutlastsTheWindow_IsStillOneChoice) {
  LearningOptions options = Halving(1);
  options.window = 2;
  Traveller traveller(options);
  Wander(traveller, {{0, 1.0}, {0, 1.0}, {0, 1.0}, {0, 1.0}, {0, 1.0}, {0, 1.0}});
  traveller.learner.EndEpisode();
  EXPECT_THAT(traveller.learner.Write(), ::testing::HasSubstr("(value (Walk 0) 1.5 1)"));
}

TEST(IcarusLearningTest, WithoutTrace_TheEstimateOfTheNextChoiceStandsForWhatFollows) {
  Traveller traveller(Halving(0));
  Findings findings;
  traveller.learner.Read("(value (Go road) 7 9) (value (Walk 1) 3 9) (value (TakeRoad 1) 20 1)",
                         "v", findings);
  ASSERT_TRUE(findings.empty());
  Wander(traveller, {{0, 2.0}, {1, 4.0}});
  traveller.learner.EndEpisode();
  EXPECT_THAT(traveller.learner.Write(), ::testing::HasSubstr("(value (Walk 0) 12 1)"));
}

TEST(IcarusLearningTest, SkillsThatAreNotNamed_HaveNoValueAndKeepTheirOrder) {
  LearningOptions options = Exploring();
  options.exploration = 1;
  options.skills = {"takeroad", "TakePath"};
  Traveller traveller(options);
  traveller.Train(5);
  EXPECT_THAT(traveller.learner.Write(),
              ::testing::Not(::testing::ContainsRegex("Rest|Walk|Stay|Go")));
  const std::array<Value, 1> place = {Value::Integer(0)};
  EXPECT_FALSE(traveller.learner.ValueOf(traveller.file.program.Find("walk"), place));
  EXPECT_TRUE(traveller.learner.ValueOf(traveller.file.program.Find("takeroad"), place));
}

TEST(IcarusLearningTest, ValuesThatFitNothing_AreFindings) {
  Traveller traveller({});
  Findings findings;
  traveller.learner.Read(
      "(value (Fly 1) 2 1)\n(value (Walk) 2 1)\n(value (Walk 1) x 1)\n(value (Walk {f}) 1 1)\n"
      "(value (Walk -3) -2.5 7)\n(value (Walk (a \"b c\" ?)) 1 1)\n(",
      "v", findings);
  EXPECT_EQ(findings.size(), 5U);
  EXPECT_EQ(traveller.learner.Write(),
            "(value (Walk (a \"b c\" ?)) 1 1)\n(value (Walk -3) -2.5 7)\n");
}

TEST(IcarusLearningTest, RealsInLists_AreToldApartByWholeNumbers) {
  Traveller traveller({});
  Findings findings;
  traveller.learner.Read("(value (Walk (a 1.6 (2.25))) 2.5 1)", "v", findings);
  EXPECT_TRUE(findings.empty());
  EXPECT_EQ(traveller.learner.Write(), "(value (Walk (a 2 (2))) 2.5 1)\n");
  const std::uint32_t walk = traveller.file.program.Find("walk");
  Arena arena;
  const auto value = [&](double first, const Value& second) {
    const std::array<Value, 1> inner = {second};
    const std::array<Value, 3> outer = {Value::Symbol(traveller.names.Intern("a")),
                                        Value::Real(first), arena.MakeList(inner)};
    const std::array<Value, 1> place = {arena.MakeList(outer)};
    return traveller.learner.ValueOf(walk, place);
  };
  EXPECT_EQ(value(2.4, Value::Real(1.7)), 2.5);
  EXPECT_EQ(value(2.0, Value::Integer(2)), 2.5);
  EXPECT_EQ(value(2.6, Value::Integer(2)), 0);
  EXPECT_EQ(value(2.0, Value::Real(2.6)), 0);
}

TEST(IcarusLearningTest, Reals_AreToldApartByWholeNumbers) {
  Traveller traveller({});
  Findings findings;
  traveller.learner.Read("(value (Walk 3) 2.5 1)", "v", findings);
  const std::uint32_t walk = traveller.file.program.Find("walk");
  const std::array<Value, 1> near = {Value::Real(3.4)};
  const std::array<Value, 1> far = {Value::Real(3.6)};
  EXPECT_EQ(traveller.learner.ValueOf(walk, near), 2.5);
  EXPECT_EQ(traveller.learner.ValueOf(walk, far), 0);
}

}  // namespace
}  // namespace latchwork::icarus::testing

// SPDX-License-Identifier: BSD-3-Clause
//
// A layer that learns from the rewards in its latches.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "tests/reasoners/icarus/program_mind.h"
#include "tests/temporary_folder.h"

namespace latchwork::icarus::testing {
namespace {

using sdk::ArgumentType;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// Two ways to go; the first in the program pays nothing.
constexpr std::string_view kProgram = R"((top (Top))
(Top () :means ((TakeRoad) (TakePath)))
(TakeRoad () :means ((Go road)))
(TakePath () :means ((Go path)))
(Go (?way) :action ({go ?way}))
)";

struct Walker {
  Walker(const std::filesystem::path& values, bool learns) : mind(kProgram) {
    mind.Input("reward", {ArgumentType::kReal});
    mind.Output("go", {ArgumentType::kSymbol});
    mind.Parameter("acts", "value");
    if (learns || std::filesystem::exists(values)) mind.Parameter("values", values.string());
    if (learns) {
      mind.Parameter("learn", "true");
      mind.Parameter("exploration", "0.5");
      mind.Parameter("discount", "0");
      mind.Parameter("exploration_seed", "3");
    }
    mind.Load();
    mind.Latch(0, {});
  }

  std::string Walk() {
    const std::vector<std::string> ways = mind.Decide();
    mind.Latch(0, {ways == std::vector<std::string>{"go(path)"} ? "reward(1.0)" : "reward(0.0)"});
    return ways.empty() ? "" : ways.front();
  }

  ProgramMind mind;
};

std::string Contents(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(IcarusLayerLearningTest, Rewards_TurnTheChoiceOfTheLayerThatComesAfter) {
  const test::TemporaryFolder folder;
  const std::filesystem::path values = folder.path() / "learned.values";
  {
    Walker novice(values, false);
    EXPECT_EQ(novice.Walk(), "go(road)") << "the first means, as nothing is learned";
  }
  {
    Walker learner(values, true);
    for (int i = 0; i < 200; ++i) learner.Walk();
  }
  EXPECT_THAT(Contents(values), HasSubstr("(value (TakePath)"));
  Walker expert(values, false);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(expert.Walk(), "go(path)");
}

TEST(IcarusLayerLearningTest, ValuesThatCannotBeWritten_LeaveTheOldOnes) {
  const test::TemporaryFolder folder;
  const std::filesystem::path values = folder.path() / "learned.values";
  const std::string old = "(value (TakePath) 1 9)\n";
  std::ofstream(values) << old;
  ::testing::internal::CaptureStderr();
  {
    Walker learner(values, true);
    learner.Walk();
    std::filesystem::create_directory(values.string() + ".new");  // In the way of what is written.
  }
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("keeps those it had"));
  EXPECT_EQ(Contents(values), old);
}

TEST(IcarusLayerLearningTest, FolderThatDoesNotExist_IsRefusedAtOnce) {
  const test::TemporaryFolder folder;
  ProgramMind mind(kProgram);
  mind.Parameter("values", (folder.path() / "nowhere" / "learned.values").string());
  mind.Parameter("learn", "true");
  mind.Input("reward", {ArgumentType::kReal});
  mind.Output("go", {ArgumentType::kSymbol});
  EXPECT_THAT(Format(mind.TryLoad()), HasSubstr("learned values cannot be written here"));
}

TEST(IcarusLayerLearningTest, LearnedSkillsThatTheProgramLacks_AreAllNamed) {
  ProgramMind mind(kProgram);
  mind.Parameter("learn", "true");
  mind.Parameter("learned_skills", "TakeRoad TakePat Fly");
  mind.Input("reward", {ArgumentType::kReal});
  mind.Output("go", {ArgumentType::kSymbol});
  const std::string said = Format(mind.TryLoad());
  EXPECT_THAT(said, HasSubstr("learned_skills: the program has no skill 'TakePat'"));
  EXPECT_THAT(said, HasSubstr("did you mean 'TakePath'?"));
  EXPECT_THAT(said, HasSubstr("the program has no skill 'Fly'"));
  EXPECT_THAT(said, Not(HasSubstr("'TakeRoad'")));
}

}  // namespace
}  // namespace latchwork::icarus::testing

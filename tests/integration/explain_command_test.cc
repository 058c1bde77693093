// SPDX-License-Identifier: BSD-3-Clause
//
// `latchwork explain` as it is used.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/run_command.h"

namespace latchwork::testing {
namespace {

using ::testing::HasSubstr;

CommandResult Explain(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"explain", "examples/office/scenario1.xml"});
  return RunLatchwork(arguments, LATCHWORK_SOURCE_DIR);
}

const std::vector<std::string> kCircumscribed = {"--scenario",
                                                 "examples/office/circumscription.xml"};

TEST(ExplainCommandTest, Circumscription_SaysHowAndWhatWasAssumedAndWhy) {
  std::vector<std::string> arguments = {"--tick", "40",        "--layer",
                                        "avoid",  "--why-not", "halt_robot"};
  arguments.insert(arguments.end(), kCircumscribed.begin(), kCircumscribed.end());
  const CommandResult result = Explain(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("layer avoid: proved"));
  EXPECT_THAT(result.out, HasSubstr("conclusion: "));
  EXPECT_THAT(result.out, HasSubstr("[latch sonar]"));
  EXPECT_THAT(result.out, HasSubstr("assumption, made: nothing concludes halt_robot"));
  EXPECT_THAT(result.out, HasSubstr("why not: nothing concludes halt_robot"));
}

TEST(ExplainCommandTest, DefaultsThatNothingComesNear_AreSummedUp) {
  std::vector<std::string> arguments = {"--tick", "40", "--layer", "itinerary"};
  arguments.insert(arguments.end(), kCircumscribed.begin(), kCircumscribed.end());
  const CommandResult result = Explain(arguments);
  EXPECT_THAT(result.out, ::testing::ContainsRegex(
                              "assumption, made: nothing concludes any of [0-9]+ instances of "
                              "door_shut, nor could: door_shut\\("));
  EXPECT_THAT(result.out, ::testing::Not(HasSubstr("nothing concludes door_shut")));
}

TEST(ExplainCommandTest, Json_IsAnObjectALine) {
  std::vector<std::string> arguments = {"--tick", "40", "--json"};
  arguments.insert(arguments.end(), kCircumscribed.begin(), kCircumscribed.end());
  const CommandResult result = Explain(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  std::istringstream lines(result.out);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const auto object = nlohmann::json::parse(line, nullptr, false);
    ASSERT_TRUE(object.is_object()) << line;
    EXPECT_TRUE(object.contains("explanation"));
  }
  EXPECT_GE(count, 2U);
}

TEST(ExplainCommandTest, Prover_ProvesItsConclusions) {
  const CommandResult result = Explain({"--tick", "40", "--layer", "avoid", "--why-not", "fwd(X)"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("holds:\n"));
  EXPECT_THAT(result.out, HasSubstr("why not: fwd(X0) holds:\n"));
  EXPECT_THAT(result.out, HasSubstr("assumption, made: nothing concludes halt_robot:\n  '"));
}

TEST(ExplainCommandTest, ReasonerWithoutReasons_NamesOneThatHasThem) {
  const CommandResult result = Explain({"--tick", "40", "--layer", "avoid", "--why-not",
                                        "halt_robot", "--scenario", "examples/office/icarus.xml"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("layer avoid: reasoner icarus does not keep all reasons; "
                                    "'latchwork icarus record --layer avoid' writes"));
}

TEST(ExplainCommandTest, ReasonerOfTheoriesWithoutReasons_SaysWhatToChange) {
  if (RunShell("command -v swipl", LATCHWORK_SOURCE_DIR).exit_code != 0) {
    GTEST_SKIP() << "there is no SWI-Prolog";
  }
  const CommandResult result =
      Explain({"--tick", "40", "--layer", "avoid", "--scenario", "examples/office/swipl.xml"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr(", whose derivation is not kept\n"));
  EXPECT_THAT(result.out, HasSubstr("assumption, made: halt_robot was not proved, for reasons that "
                                    "are not kept\n"));
  EXPECT_THAT(result.out, HasSubstr("for the same theory <reasoner plugin=\"circumscription\"/>"));
}

TEST(ExplainCommandTest, TickWithoutADecision_IsSaid) {
  const CommandResult result = Explain({"--tick", "1", "--layer", "itinerary"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, "no layer 'itinerary' decides at tick 1\n");
}

TEST(ExplainCommandTest, WrongAtom_IsWrongUsageWithItsPlace) {
  const CommandResult result = Explain({"--why-not", "fwd("});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("--why-not:1:5: "));
}

}  // namespace
}  // namespace latchwork::testing

// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/experiment/experiment.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "latchwork/logic/diagnostic.h"

namespace latchwork::compare {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kFile = LATCHWORK_SOURCE_DIR "/examples/compare/experiment.xml";

std::string ErrorsOf(const std::string& text) {
  const ExperimentFile read = ReadExperimentText(text, kFile);
  EXPECT_FALSE(read.experiment.has_value());
  return logic::Format(read.diagnostics);
}

TEST(ExperimentTest, EverythingIsRead) {
  const ExperimentFile read = ReadExperimentText(
      R"(<experiment format="1" name="e" seeds="3-7" level="0.01" wall="60s" memory="100MB">
           <scenario name="floor" file="../office/scenario1.xml"/>
           <agent name="a"/>
           <agent name="b" fragment="../office/icarus.xml"><set name="avoid.x" value="1"/></agent>
         </experiment>)",
      kFile);
  ASSERT_EQ(logic::Format(read.diagnostics), "");
  EXPECT_EQ(read.experiment->first_seed, 3U);
  EXPECT_EQ(read.experiment->last_seed, 7U);
  EXPECT_EQ(read.experiment->level, 0.01);
  EXPECT_EQ(read.experiment->limits.wall_seconds, 60.0);
  EXPECT_EQ(read.experiment->limits.memory_mb, 100U);
  ASSERT_EQ(read.experiment->contenders.size(), 2U);
  EXPECT_THAT(read.experiment->contenders[1].settings, ::testing::ElementsAre("avoid.x=1"));
}

TEST(ExperimentTest, ValuesOfTheWrongShape_AllAtOnceWithTheirPlaces) {
  const std::string errors = ErrorsOf(
      "<experiment format=\"1\" name=\"e\" seeds=\"1\">\n"
      "<scenario name=\"same floor\" file=\"../office/scenario1.xml\"/>\n"
      "<agent nam=\"a\"/>\n"
      "</experiment>");
  EXPECT_THAT(errors, HasSubstr("experiment.xml:1:40: error: '1' is not seeds"));
  EXPECT_THAT(errors, Not(HasSubstr("number of the format")));
  EXPECT_THAT(errors, HasSubstr("experiment.xml:2:17: error: 'same floor' is not a name"));
  EXPECT_THAT(errors, HasSubstr("did you mean 'name'?"));
}

TEST(ExperimentTest, UnknownElements_Named) {
  EXPECT_THAT(ErrorsOf("<experiment format=\"1\" name=\"e\" seeds=\"1-2\"><agnet/></experiment>"),
              HasSubstr("did you mean 'agent'?"));
  EXPECT_THAT(ErrorsOf("<agent format=\"1\"/>"), HasSubstr("the root of the file is <agent>"));
}

TEST(ExperimentTest, WhatCannotBeRun_Said) {
  const std::string errors = ErrorsOf(
      "<experiment format=\"1\" name=\"e\" seeds=\"9-2\">"
      "<agent name=\"a\" fragment=\"no.xml\"/><agent name=\"a\"/></experiment>");
  EXPECT_THAT(errors, HasSubstr("the last seed comes before the first"));
  EXPECT_THAT(errors, HasSubstr("there is no file"));
  EXPECT_THAT(errors, HasSubstr("there are two <agent> called 'a'"));
  EXPECT_THAT(errors, HasSubstr("there is no <scenario>"));
}

TEST(ExperimentTest, MistakesOfShapeAndOfSense_InOnePassEachWithItsLine) {
  const std::string errors = ErrorsOf(
      "<experiment format=\"1\" name=\"e\" seeds=\"9-2\" level=\"2\">\n"
      "<scenario name=\"s\" file=\"no.xml\"/>\n"
      "<agent nam=\"a\"/><agent name=\"b\"/><agent name=\"b\"/>\n"
      "</experiment>");
  EXPECT_THAT(errors, HasSubstr("1:40: error: the last seed comes before the first"));
  EXPECT_THAT(errors, HasSubstr("'2' is not a level"));
  EXPECT_THAT(errors, HasSubstr("2:26: error: there is no file"));
  EXPECT_THAT(errors, HasSubstr("  2 | <scenario name=\"s\" file=\"no.xml\"/>\n"));
  EXPECT_THAT(errors, HasSubstr("did you mean 'name'?"));
  EXPECT_THAT(errors, HasSubstr("there are two <agent> called 'b'"));
}

TEST(ExperimentTest, AstronomicNumbers_AreRefused) {
  const auto with = [](const std::string& seeds) {
    std::string text = "<experiment format=\"1\" name=\"e\" seeds=\"" + seeds + "\">";
    for (int i = 0; i < 20; ++i) {
      text += fmt::format("<scenario name=\"s{}\" file=\"../office/scenario1.xml\"/>", i);
    }
    return text + "<agent name=\"a\"/><agent name=\"b\"/></experiment>";
  };
  EXPECT_THAT(ErrorsOf(with("1-99999999999999999999")), HasSubstr("is not seeds"));
  EXPECT_THAT(ErrorsOf(with("1-18446744073709551615")), HasSubstr("is not seeds"));
  EXPECT_THAT(ErrorsOf(with("-1")), HasSubstr("is not seeds"));
  EXPECT_THAT(ErrorsOf(with("1-999999999")), HasSubstr("more than 100000 seeds"));
  EXPECT_THAT(ErrorsOf(with("1-30000")), HasSubstr("make more than 1000000 runs"));
}

}  // namespace
}  // namespace latchwork::compare

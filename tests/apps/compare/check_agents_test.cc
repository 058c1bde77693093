// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/experiment/check_agents.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace latchwork::compare {
namespace {

using ::testing::HasSubstr;

constexpr const char* kFile = LATCHWORK_SOURCE_DIR "/examples/compare/experiment.xml";

constexpr const char* kText =
    "<experiment format=\"1\" name=\"e\" seeds=\"1-3\" memory=\"900MB\">\n"
    "<scenario name=\"floor\" file=\"../office/scenario1.xml\"/>\n"
    "<agent name=\"a\"/>\n"
    "<agent name=\"b\"><set name=\"avoid.wit\" value=\"1\"/></agent>\n"
    "</experiment>";

/// With a shell that says `script` in place of what checks.
logic::Diagnostics Checked(const std::string& script) {
  const auto read = ReadExperimentText(kText, kFile);
  const std::atomic<bool> never = false;
  return CheckAgents(*read.experiment, PlanRuns(*read.experiment),
                     {"/bin/sh", {"-c", script, "sh"}}, never);
}

TEST(CheckAgentsTest, SoundAgents_NothingIsSaid) {
  EXPECT_TRUE(Checked("[ \"$1\" = --version ] || echo '[]'").empty());
}

TEST(CheckAgentsTest, WhatSeveralAgentsShare_IsToldOnce) {
  const auto told = Checked(
      R"([ "$1" = --version ] && exit; echo '[{"file":"map.xml","line":2,"column":3,"message":"no door","hint":""}]'; exit 3)");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(logic::Format(told), "map.xml:2:3: error: no door\n");
}

TEST(CheckAgentsTest, BadSetting_StandsInTheExperiment) {
  const std::string told = logic::Format(Checked(
      R"(case "$*" in *wit*) echo '[{"file":"command line","line":0,"column":0,"message":"'"there is no parameter 'wit'"'","hint":""}]'; exit 3;; esac; echo '[]')"));
  EXPECT_THAT(told, HasSubstr("experiment.xml:4:28: error: there is no parameter 'wit'\n  4 | "));
}

TEST(CheckAgentsTest, NoAnswer_TheLimitsAreTooSmall) {
  const logic::Diagnostics told = Checked("kill -9 $$");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(logic::Format(told),
              AllOf(HasSubstr("experiment.xml:1:53: error: no run can begin within 900 MB and "
                              "300 s: the program was ended by signal 9"),
                    HasSubstr("hint: allow more")));
}

TEST(CheckAgentsTest, AgentWhoseCheckCrashes_IsLeftToItsRuns) {
  EXPECT_TRUE(Checked("[ \"$1\" = --version ] || kill -9 $$").empty());
}

}  // namespace
}  // namespace latchwork::compare

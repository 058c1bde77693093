// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/config/agent_fixture.h"

namespace latchwork::config {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::string_view kIncluding =
    "<agent format=\"1\" name=\"a\" duration=\"1s\">\n<include file=\"one.xml\"/>\n</agent>";

TEST_F(AgentTest, IncludesAreSplicedInPlace) {
  const std::string good = GoodAgent();
  const std::size_t begin = good.find("<world");
  const std::size_t end = good.find("</agent>");
  Write("one.xml", "<fragment format=\"1\">" + good.substr(begin, end - begin) + "</fragment>");
  EXPECT_THAT(
      Errors("<agent format=\"1\" name=\"a\" duration=\"1s\"><include file=\"one.xml\"/></agent>"),
      IsEmpty());
}

TEST_F(AgentTest, AnIncludeThatIsMissingCausesNoFollowUps) {
  EXPECT_THAT(Errors(kIncluding), ElementsAre("2:16: the included file 'one.xml' cannot be read "
                                              "[there is no such file]"));
}

TEST_F(AgentTest, AnIncludeOfItselfIsRefused) {
  Write("one.xml", "<fragment format=\"1\"><include file=\"./one.xml\"/></fragment>");
  EXPECT_THAT(Errors(kIncluding), ElementsAre("one.xml:1:37: 'one.xml' includes itself"));
}

TEST_F(AgentTest, AFileIncludedTwiceIsRefused) {
  Write("one.xml", "<fragment format=\"1\"/>");
  EXPECT_THAT(
      Errors("<agent format=\"1\" name=\"a\" duration=\"1s\">\n<include file=\"one.xml\"/>\n"
             "<include file=\"one.xml\"/>\n</agent>"),
      ElementsAre("3:16: 'one.xml' is included twice [first at agent.xml:2]"));
}

TEST_F(AgentTest, DeepIncludesAreRefused) {
  Write("one.xml", "<fragment format=\"1\"><include file=\"2.xml\"/></fragment>");
  for (int i = 2; i < 20; ++i) {
    Write(std::to_string(i) + ".xml", "<fragment format=\"1\"><include file=\"" +
                                          std::to_string(i + 1) + ".xml\"/></fragment>");
  }
  EXPECT_THAT(Errors(kIncluding),
              ElementsAre("15.xml:1:37: includes are nested more than 16 deep"));
}

TEST_F(AgentTest, AFragmentOnTopOverrides) {
  Write("agent.xml", GoodAgent());
  Write("top.xml",
        "<fragment format=\"1\"><override part=\"world\">"
        "<param name=\"people\" value=\"1\"/></override></fragment>");
  const AgentFile file = ReadAgentFile(folder_.path() / "agent.xml", FakeCatalog(), {}, symbols_,
                                       {folder_.path() / "top.xml"});
  ASSERT_TRUE(file.agent) << logic::Format(file.diagnostics);
  EXPECT_EQ(file.agent->world.parameters.Integer("people"), 1);
}

TEST_F(AgentTest, AFragmentIsNoAgent) {
  EXPECT_THAT(Errors("<fragment format=\"1\"/>"),
              ElementsAre("1:1: this is a fragment, which is only there to be included [give the "
                          "agent file that includes it]"));
}

TEST_F(AgentTest, AnAgentIsNoFragment) {
  Write("one.xml", GoodAgent());
  EXPECT_THAT(Errors(kIncluding),
              ElementsAre("one.xml:1:1: an included file is a <fragment>, this is an <agent>"));
}

TEST_F(AgentTest, AnotherFormatIsRefusedWithoutJudgingIt) {
  EXPECT_THAT(
      Errors("<agent format=\"2\" colour=\"red\"><limb/></agent>"),
      ElementsAre("1:16: format '2' is not known [this build of latchwork reads format 1]"));
}

}  // namespace
}  // namespace latchwork::config

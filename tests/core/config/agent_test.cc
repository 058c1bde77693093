// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/config/agent.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/config/agent_fixture.h"

namespace latchwork::config {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST_F(AgentTest, ResolvesAGoodFile) {
  const AgentFile file = Read(GoodAgent());
  ASSERT_TRUE(file.agent) << logic::Format(file.diagnostics);
  const AgentDescription& agent = *file.agent;
  EXPECT_EQ(agent.name, "test");
  EXPECT_EQ(agent.tick_us, 100'000U);
  EXPECT_EQ(agent.max_ticks, 600U);
  EXPECT_EQ(agent.world.parameters.Integer("people"), 7);
  ASSERT_EQ(agent.layers.size(), 2U);
  EXPECT_EQ(agent.layers[0].reasoner.inferences, 1000U);
  EXPECT_EQ(agent.layers[0].reasoner.depth, 24U);
  EXPECT_EQ(agent.layers[0].language, "tptp");
  EXPECT_FALSE(agent.layers[0].fallback);
  EXPECT_EQ(agent.layers[1].period, 2U);
  EXPECT_EQ(agent.layers[1].phase, 1U);
  EXPECT_EQ(agent.layers[1].latency, 1U);
  EXPECT_EQ(agent.layers[1].reasoner.inferences, sdk::Budget().inferences);
  ASSERT_EQ(agent.wires.size(), 4U);
  EXPECT_EQ(agent.wires[1].from, (PortAddress{1, 0}));
  EXPECT_EQ(agent.wires[1].to, (PortAddress{0, 1}));
  EXPECT_EQ(agent.wires[1].stale_after, 6U);
  EXPECT_EQ(agent.wires[3].stale_after, std::nullopt);
  EXPECT_EQ(agent.wires[3].transfer, Transfer::kOpen);
  ASSERT_EQ(agent.events.size(), 1U);
  EXPECT_EQ(agent.events[0].tick, 300U);
  EXPECT_EQ(logic::ToString(agent.events[0].fact), "out_of_order(e2)");
}

TEST_F(AgentTest, ReadsFallbackMinimizedAndInhibition) {
  std::string text =
      GoodAgentWith("</layer>",
                    "<minimize predicate=\"halt_robot/0\" depth=\"9\" priority=\"2\"/>"
                    "<vary predicate=\"object/1\"/><fix predicate=\"echo/2\"/>"
                    "<fallback><fact port=\"motion\">halt</fact>"
                    "<fact port=\"motion\"> turn(0.5) </fact></fallback></layer>");
  text.insert(text.find("<event"), "<inhibit by=\"seek.push\" output=\"avoid.chatter\"/>");
  const AgentFile file = Read(text);
  ASSERT_TRUE(file.agent) << logic::Format(file.diagnostics);
  const LayerDescription& layer = file.agent->layers[0];
  ASSERT_EQ(layer.minimized.size(), 1U);
  EXPECT_EQ(logic::ToString(layer.minimized[0].predicate), "halt_robot/0");
  EXPECT_EQ(layer.minimized[0].depth, 9U);
  EXPECT_EQ(layer.minimized[0].priority, 2U);
  EXPECT_EQ(layer.varied.size(), 1U);
  EXPECT_EQ(layer.fixed.size(), 1U);
  ASSERT_TRUE(layer.fallback);
  ASSERT_EQ(layer.fallback->size(), 2U);
  EXPECT_EQ(logic::ToString(layer.fallback->at(1).fact), "turn(0.5)");
  ASSERT_EQ(file.agent->inhibitions.size(), 1U);
  EXPECT_EQ(file.agent->inhibitions[0].hold, 2U);
}

TEST_F(AgentTest, ReportsSixMistakesAtOnce) {
  std::string text = GoodAgent();
  const auto replace = [&](std::string_view piece, std::string_view with) {
    text.replace(text.find(piece), piece.size(), with);
  };
  replace("value=\"7\"", "value=\"many\"");
  replace("period=\"100ms\"", "period=\"150ms\"");
  replace("depth=\"24\"", "deph=\"24\"");
  replace("plugin=\"seek\"", "plugin=\"sek\"");
  replace("world.sonar", "world.sonr");
  replace("out_of_order(e2)", "out_of_order(E)");
  EXPECT_THAT(
      Errors(text),
      ElementsAre(
          "2:50: parameter 'people' of world 'hall' must be an integer from 0 to 50, not 'many' "
          "[the default is '4']",
          "3:44: period '150ms' is no multiple of the tick (100ms) [use 100ms or 200ms]",
          "4:43: <reasoner> has no attribute 'deph' [did you mean 'depth'?]",
          "6:28: there is no layer plugin 'sek' [did you mean 'seek'?]",
          "9:13: 'world' has no sensor 'sonr' [did you mean 'sonar'?]",
          "13:23: 'out_of_order(E)' is not ground: a fact has no variables [names start with a "
          "small letter]"));
}

TEST_F(AgentTest, GivesTheExcerpt) {
  const AgentFile file = Read(GoodAgentWith("plugin=\"hall\"", "plugin=\"hal\""));
  ASSERT_EQ(file.diagnostics.size(), 1U);
  EXPECT_EQ(file.diagnostics[0].excerpt,
            "<world plugin=\"hal\"><param name=\"people\" value=\"7\"/></world>");
}

TEST_F(AgentTest, FingerprintFollowsTheBytesOfAllFiles) {
  const std::string text = GoodAgentWith("<event", "<include file=\"part.xml\"/><event");
  Write("part.xml", "<fragment format=\"1\"/>");
  const AgentFile one = Read(text);
  const AgentFile again = Read(text);
  Write("part.xml", "<fragment format=\"1\" />");
  const AgentFile other = Read(text);
  ASSERT_TRUE(one.agent && again.agent && other.agent);
  EXPECT_EQ(one.agent->fingerprint.size(), 16U);
  EXPECT_EQ(one.agent->fingerprint, again.agent->fingerprint);
  EXPECT_NE(one.agent->fingerprint, other.agent->fingerprint);
}

TEST_F(AgentTest, PluginFailureIsToldFromOtherErrors) {
  EXPECT_TRUE(Read(GoodAgentWith("plugin=\"seek\"", "plugin=\"torn\"")).plugin_failure);
  EXPECT_TRUE(Read(GoodAgentWith("plugin=\"seek\"", "plugin=\"none\"")).plugin_failure);
  EXPECT_FALSE(Read(GoodAgentWith("200ms", "250ms")).plugin_failure);
}

TEST_F(AgentTest, OverridesParametersPeriodAndReasoner) {
  const std::string text = GoodAgentWith(
      "<event",
      "<override part=\"avoid\" period=\"300ms\"><param name=\"gain\" value=\"2\"/>"
      "<reasoner plugin=\"icarus\" depth=\"5\"/></override>"
      "<override part=\"world\"><param name=\"people\" value=\"8\"/></override><event");
  const AgentFile file =
      Read(text, {{"world", "people", "9"}, {"avoid.reasoner", "cache", "false"}});
  ASSERT_TRUE(file.agent) << logic::Format(file.diagnostics);
  const LayerDescription& avoid = file.agent->layers[0];
  EXPECT_EQ(avoid.period, 3U);
  EXPECT_EQ(avoid.parameters.Real("gain"), 2.0);
  EXPECT_EQ(avoid.reasoner.plugin, "icarus");
  EXPECT_EQ(avoid.language, "icarus");
  EXPECT_EQ(avoid.reasoner.inferences, 1000U);
  EXPECT_EQ(avoid.reasoner.depth, 5U);
  EXPECT_FALSE(avoid.reasoner.parameters.Boolean("cache"));
  EXPECT_EQ(file.agent->world.parameters.Integer("people"), 9);
  EXPECT_EQ(file.agent->world.parameters.PlaceOf("people").file, "command line");
}

TEST_F(AgentTest, WrongCommandLineOverridesAreReported) {
  EXPECT_THAT(Errors(GoodAgent(), {{"avoidd", "gain", "1"}, {"avoid", "gian", "1"}}),
              ElementsAre("command line:0:0: there is no part 'avoidd' to override [did you mean "
                          "'avoid'?]",
                          "command line:0:0: layer 'avoid' has no parameter 'gian' [did you mean "
                          "'gain'?]"));
}

TEST_F(AgentTest, AMissingFileIsReported) {
  const AgentFile file = ReadAgentFile(folder_.path() / "none.xml", FakeCatalog(), {}, symbols_);
  ASSERT_EQ(file.diagnostics.size(), 1U);
  EXPECT_EQ(file.diagnostics[0].message, "there is no such file");
}

TEST_F(AgentTest, MutatedFilesNeverCrash) {
  const std::string good = GoodAgent();
  constexpr std::string_view kBytes = "<>\"'=/&.;-0aZ \n\x80\xff";
  std::uint64_t state = 1;
  const auto next = [&state](std::size_t count) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state >> 33U) % count;
  };
  std::size_t wrong = 0;
  for (int round = 0; round < 1000; ++round) {
    std::string text = good;
    for (std::size_t edits = 1 + next(3); edits > 0; --edits) {
      const std::size_t at = next(text.size());
      if (next(4) == 0) {
        text.erase(at, 1 + next(20));
      } else {
        text[at] = kBytes[next(kBytes.size())];
      }
    }
    const AgentFile file = Read(text);
    ASSERT_NE(file.agent.has_value(), !file.diagnostics.empty());
    wrong += file.diagnostics.empty() ? 0 : 1;
  }
  EXPECT_GT(wrong, 500U);
}

}  // namespace
}  // namespace latchwork::config

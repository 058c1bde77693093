// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/schedule/fakes.h"

namespace latchwork::schedule::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class AssembleAgentTest : public ::testing::Test {
 protected:
  AssembleAgentTest() { fake.AddLayer({}, {Port("out", {{"go", {}}})}); }

  std::vector<std::string> Messages(const AssembledAgent& assembled) {
    std::vector<std::string> messages;
    for (const auto& each : assembled.diagnostics) messages.push_back(each.message);
    return messages;
  }

  FakeAgent fake;
};

TEST_F(AssembleAgentTest, LoadsWorldAndBodies) {
  fake.agent.tick_us = 50'000;
  const AssembledAgent assembled = fake.Assemble(7);
  ASSERT_TRUE(assembled.agent);
  EXPECT_EQ(fake.world->setup.seed, 7U);
  EXPECT_EQ(fake.world->setup.tick_seconds, 0.05);
  EXPECT_EQ(fake.world->setup.data, "data/world");
  EXPECT_EQ(fake.world->setup.symbols, &fake.symbols);
  EXPECT_EQ(fake.reasoner(0).body.goals.size(), 1U);
}

TEST_F(AssembleAgentTest, DiagnosticsOfAllPartsComeAtOnce) {
  fake.AddLayer({}, {});
  fake.world->load_diagnostics = {{{}, "no map", "", ""}};
  fake.reasoner(0).load_diagnostics = {{{}, "bad axiom", "", ""}, {{}, "bad goal", "", ""}};
  fake.reasoner(1).load_diagnostics = {{{}, "bad clause", "", ""}};
  const AssembledAgent assembled = fake.Assemble();
  EXPECT_FALSE(assembled.agent);
  EXPECT_FALSE(assembled.plugin_failure);
  EXPECT_THAT(Messages(assembled), ElementsAre("no map", "bad axiom", "bad goal", "bad clause"));
}

TEST_F(AssembleAgentTest, PartsThatCannotBeMadeArePluginFailures) {
  fake.agent.world.plugin = "moon";
  fake.description(0).reasoner.plugin = "oracle";
  const AssembledAgent assembled = fake.Assemble();
  EXPECT_TRUE(assembled.plugin_failure);
  EXPECT_THAT(Messages(assembled),
              ElementsAre("there is no plugin moon", "there is no plugin oracle"));
}

TEST_F(AssembleAgentTest, MinimizedOfTheAgentFileReplacesTheBodys) {
  fake.description(0).minimized = {{{fake.symbols.Intern("ab"), 1}, 3}};
  ASSERT_TRUE(fake.Assemble().agent);
  ASSERT_EQ(fake.reasoner(0).body.minimized.size(), 1U);
  EXPECT_EQ(fake.reasoner(0).body.minimized[0].depth, 3U);
}

TEST_F(AssembleAgentTest, FallbackMustKeepTheContract) {
  fake.description(0).fallback = {{{0, fake.Fact("fly")}, {5, fake.Fact("go")}}};
  EXPECT_THAT(
      Messages(fake.Assemble()),
      ElementsAre("layer l0: its fallback fly breaks its contract: port out does not declare "
                  "fly/0",
                  "layer l0: its fallback go breaks its contract: there is no output port 5"));
}

class ThrowingLayer : public FakeLayer {
 public:
  sdk::Body MakeBody(std::string_view, const sdk::Parameters&, const std::filesystem::path&,
                     logic::SymbolTable&) const override {
    throw std::runtime_error("no body");
  }
};

TEST_F(AssembleAgentTest, LayerThatThrowsIsADiagnostic) {
  fake.layers[0] = std::make_shared<ThrowingLayer>();
  EXPECT_THAT(Messages(fake.Assemble()),
              ElementsAre("plugin layer0 failed while it was loaded: no body"));
}

class StrayGoalLayer : public FakeLayer {
 public:
  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data,
                     logic::SymbolTable& symbols) const override {
    sdk::Body body = FakeLayer::MakeBody(language, parameters, data, symbols);
    body.goals.push_back({logic::Atom(symbols.Intern("stray")), 0, sdk::Goal::Answers::kFirst, 0});
    return body;
  }
};

TEST_F(AssembleAgentTest, GoalOutsideTheContractIsADiagnostic) {
  fake.layers[0] = std::make_shared<StrayGoalLayer>();
  EXPECT_THAT(Messages(fake.Assemble()),
              ElementsAre("layer plugin layer0: its goal stray has no output port that declares "
                          "stray/0"));
}

TEST(MakeCatalogTest, UnknownPluginIsNothingWithoutAnError) {
  const plugin::Registry registry({});
  const config::Catalog catalog = MakeCatalog(registry);
  std::string error;
  EXPECT_FALSE(catalog.find(sdk::PluginKind::kLayer, "avoid", error));
  EXPECT_EQ(error, "");
  EXPECT_THAT(catalog.names(sdk::PluginKind::kWorld), IsEmpty());
}

TEST(MakeCatalogTest, DescribesAReasonerFromItsLibrary) {
  const plugin::Registry registry({std::filesystem::path(LATCHWORK_BINARY_DIR) / "fault_plugins"});
  const config::Catalog catalog = MakeCatalog(registry);
  std::string error;
  const auto facts = catalog.find(sdk::PluginKind::kReasoner, "throws", error);
  ASSERT_TRUE(facts) << error;
  EXPECT_EQ(facts->languages.size(), 1U);
  EXPECT_NE(MakePartFactory(registry).reasoner("throws").object, nullptr);
}

}  // namespace
}  // namespace latchwork::schedule::testing

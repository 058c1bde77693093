// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "latchwork/sdk/decision.h"
#include "latchwork/sdk/layer.h"

namespace latchwork::sdk {
namespace {

const std::vector<ParameterSpec> kTable = {
    {.name = "gain",
     .type = ParameterType::kReal,
     .default_value = "0.5",
     .minimum = 0,
     .unit = "m"},
    {.name = "people", .type = ParameterType::kInteger, .default_value = "4", .maximum = 9},
    {.name = "noise", .type = ParameterType::kBoolean, .default_value = "true"},
    {.name = "mode", .default_value = "walk", .choices = {"walk", "ride"}},
    {.name = "map", .type = ParameterType::kFile, .default_value = ""},
};

std::vector<ParameterSpec> Table() {
  std::vector<ParameterSpec> table = kTable;
  table[3].type = ParameterType::kText;
  return table;
}

std::vector<std::string> Errors(const std::vector<ParameterSpec>& table,
                                const std::vector<Parameters::Given>& given) {
  logic::Diagnostics diagnostics;
  Parameters::Check(table, given, "layer 'avoid'", {"a.xml", 1, 1}, diagnostics);
  std::vector<std::string> result;
  for (const auto& d : diagnostics) result.push_back(d.message + " [" + d.hint + "]");
  return result;
}

TEST(ParametersTest, FillsInDefaults) {
  const Parameters parameters = Parameters::Defaults(Table());
  EXPECT_EQ(parameters.Real("gain"), 0.5);
  EXPECT_EQ(parameters.Integer("people"), 4);
  EXPECT_TRUE(parameters.Boolean("noise"));
  EXPECT_EQ(parameters.Text("mode"), "walk");
  EXPECT_TRUE(parameters.File("map").empty());
}

TEST(ParametersTest, LaterValuesOverrideAndFilesAreRelativeToTheirFile) {
  logic::Diagnostics diagnostics;
  const std::vector<Parameters::Given> given = {{"people", "1", {"a.xml", 2, 1}},
                                                {"people", "2", {"a.xml", 3, 1}},
                                                {"map", "maps/hall.png", {"/office/a.xml", 4, 1}}};
  const auto parameters =
      Parameters::Check(Table(), given, "world 'hall'", {"a.xml", 1, 1}, diagnostics);
  EXPECT_TRUE(diagnostics.empty());
  EXPECT_EQ(parameters.Integer("people"), 2);
  EXPECT_EQ(parameters.PlaceOf("people").line, 3U);
  EXPECT_EQ(parameters.PlaceOf("gain").line, 1U);
  EXPECT_EQ(parameters.File("map"), "/office/maps/hall.png");
}

TEST(ParametersTest, ReportsEveryMistake) {
  EXPECT_THAT(
      Errors(Table(), {{"gian", "1", {}},
                       {"gain", "-1", {}},
                       {"gain", "nan", {}},
                       {"people", "3.5", {}},
                       {"people", "10", {}},
                       {"noise", "yes", {}},
                       {"mode", "rode", {}}}),
      ::testing::ElementsAre(
          "layer 'avoid' has no parameter 'gian' [did you mean 'gain'?]",
          "parameter 'gain' of layer 'avoid' must be a number not below 0 (m), not '-1' [the "
          "default is '0.5']",
          "parameter 'gain' of layer 'avoid' must be a number not below 0 (m), not 'nan' [the "
          "default is '0.5']",
          "parameter 'people' of layer 'avoid' must be an integer not above 9, not '3.5' [the "
          "default is '4']",
          "parameter 'people' of layer 'avoid' must be an integer not above 9, not '10' [the "
          "default is '4']",
          "parameter 'noise' of layer 'avoid' must be 'true' or 'false', not 'yes' [the default is "
          "'true']",
          "parameter 'mode' of layer 'avoid' must be 'walk' or 'ride', not 'rode' [did you mean "
          "'ride'?]"));
}

TEST(ParametersTest, AMissingValueIsReported) {
  EXPECT_THAT(Errors({{.name = "goal", .type = ParameterType::kText}}, {}),
              ::testing::ElementsAre("parameter 'goal' of layer 'avoid' is missing [add <param "
                                     "name=\"goal\" value=\"…\"/>: a text]"));
}

TEST(ParametersTest, APluginWithABadDefaultIsReported) {
  EXPECT_THAT(
      Errors({{.name = "gain", .default_value = "lots"}}, {}),
      ::testing::ElementsAre("the default 'lots' of parameter 'gain' of layer 'avoid' is not "
                             "a number [the plugin is at fault; give the parameter a "
                             "value]"));
}

TEST(ParametersDeathTest, AnUndeclaredNameIsAProgrammingError) {
  const Parameters parameters = Parameters::Defaults(Table());
  EXPECT_DEATH(static_cast<void>(parameters.Real("gian")), "'gian' is not declared");
  EXPECT_DEATH(static_cast<void>(parameters.Real("people")), "another type");
}

TEST(ParameterFactsTest, OneFactForEachParameterByName) {
  logic::SymbolTable symbols;
  std::vector<std::string> facts;
  for (const auto& fact : ParameterFacts(Parameters::Defaults(Table()), symbols)) {
    facts.push_back(logic::ToString(fact));
  }
  EXPECT_THAT(facts, ::testing::ElementsAre("gain(0.5)", "map('')", "mode(walk)", "noise(true)",
                                            "people(4)"));
}

TEST(DecisionTest, ClearLeavesNothing) {
  Decision decision;
  decision.status = Status::kProved;
  decision.limit = Limit::kDepth;
  decision.conclusions.emplace_back();
  decision.assumptions.emplace_back();
  decision.statistics.inferences = 3;
  decision.message = "x";
  decision.Clear();
  EXPECT_EQ(decision.status, Status::kFailed);
  EXPECT_EQ(decision.limit, Limit::kNone);
  EXPECT_TRUE(decision.conclusions.empty() && decision.assumptions.empty());
  EXPECT_EQ(decision.statistics.inferences, 0U);
  EXPECT_TRUE(decision.message.empty());
}

TEST(DecisionTest, NamesAreWords) {
  EXPECT_EQ(Name(Status::kInconsistent), "inconsistent");
  EXPECT_EQ(Name(Limit::kInferences), "inferences");
  EXPECT_EQ(Name(Assumption::State::kMadeByBound), "made_by_bound");
}

}  // namespace
}  // namespace latchwork::sdk

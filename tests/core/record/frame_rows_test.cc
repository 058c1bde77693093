// SPDX-License-Identifier: BSD-3-Clause
#include "core/record/frame_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace latchwork::record::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string Text(const std::optional<FrameDifference>& difference) {
  if (!difference) return "";
  return difference->place + ": " + difference->recorded + " -> " + difference->now;
}

TEST(FrameRowsTest, NamesEveryPlaceInWords) {
  const std::string json =
      R"j({"tick":3,"events":[{"fact":"shut(d1)","problem":"no such door"}],)j"
      R"j("sensed":{"sonar":["a","b"],"pose":[]},)j"
      R"j("latched":[{"layer":"avoid","latch":"goal","stale":true,"facts":["g"],"version":4}],)j"
      R"j("refused":[{"layer":"avoid","latch":"goal","fact":"bad","reason":"why"},)j"
      R"j({"effector":"drive","fact":"worse","reason":"too"}],)j"
      R"j("decisions":[{"layer":"seek","status":"unknown","limit":"depth","conclusions":)j"
      R"j([{"port":"goal","fact":"c","rests_on":[1]}],"assumptions":[{"made":"m"}],)j"
      R"j("inferences":5,"fallback":{"goal":["f"]}}],)j"
      R"j("inhibited":[{"layer":"avoid","port":"motion"}],"commands":{"drive":["turn(1)"]},)j"
      R"j("faults":[{"plugin":"office","kind":"exception"}]})j";
  std::vector<std::string> places;
  for (const FrameRow& row : FrameRows(json)) places.push_back(row.place + "=" + row.value);
  EXPECT_THAT(
      places,
      ElementsAre("event 1=shut(d1)", "event 1 problem=no such door", "sensor sonar, fact 1=a",
                  "sensor sonar, fact 2=b", "sensor pose, fact=none",
                  "layer avoid, latch goal stale=true", "layer avoid, latch goal fact 1=g",
                  "layer avoid, latch goal version=4", "layer avoid, refused for latch goal=bad",
                  "layer avoid, refused for latch goal reason=why",
                  "world, refused for effector drive=worse",
                  "world, refused for effector drive reason=too", "layer seek, status=unknown",
                  "layer seek, limit=depth", "layer seek, conclusion 1 port=goal",
                  "layer seek, conclusion 1=c", "layer seek, conclusion 1 rests on 1=1",
                  "layer seek, assumption 1 made=m", "layer seek, inferences=5",
                  "layer seek, fallback goal 1=f", "layer avoid, inhibited port=motion",
                  "command drive, fact 1=turn(1)", "world, fault plugin=office",
                  "world, fault kind=exception"));
}

TEST(FrameRowsTest, FirstDifferenceIsTheEarliestInTheTick) {
  EXPECT_EQ(Text(FindDifference(R"j({"sensed":{"a":["x"]},"commands":{"c":["1"]}})j",
                                R"j({"sensed":{"a":["y"]},"commands":{"c":["2"]}})j")),
            "sensor a, fact 1: x -> y");
}

TEST(FrameRowsTest, WhatOnlyOneFrameHasIsNamed) {
  const std::string with = R"j({"sensed":{"a":["x"]},"commands":{"c":["1"]}})j";
  const std::string without = R"j({"commands":{"c":["1"]}})j";
  EXPECT_EQ(Text(FindDifference(with, without)), "sensor a, fact 1: x -> nothing");
  EXPECT_EQ(Text(FindDifference(without, with)), "sensor a, fact 1: nothing -> x");
  EXPECT_EQ(Text(FindDifference(with, R"j({"sensed":{"a":["x"]}})j")),
            "command c, fact 1: 1 -> nothing");
  EXPECT_EQ(Text(FindDifference(R"j({"sensed":{"a":["x"]}})j", with)),
            "command c, fact 1: nothing -> 1");
}

TEST(FrameRowsTest, SameValuesSpelledOtherwiseAreNoDifference) {
  EXPECT_EQ(Text(FindDifference(R"j({"tick":1,"commands":{"c":["1"]}})j",
                                R"j({ "tick": 1, "commands": {"c": ["\u0031"]} })j")),
            "");
}

TEST(FrameRowsTest, ForeignShapesDoNotMatter) {
  for (const char* json : {"", "null", "[1]", R"j({"sensed":3})j", R"j({"decisions":{"a":[[]]}})j",
                           R"j({"latched":[3,[4],{"layer":{}}],"faults":"x","end":[]})j"}) {
    const auto difference = FindDifference(json, R"j({"tick":1,"commands":{"c":["1"]}})j");
    EXPECT_TRUE(difference) << json;
  }
}

}  // namespace
}  // namespace latchwork::record::testing

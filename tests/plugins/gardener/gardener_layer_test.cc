// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/plugins/layer_mind.h"

namespace latchwork::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Two beds, a mild morning without rain, all well.
class GardenerLayerTest : public ::testing::Test {
 protected:
  GardenerLayerTest() {
    mind_.Latch("map", {"bed(b1, 40.0)", "bed(b2, 80.0)"});
    At(20, "9.0");
    mind_.Latch("weather", {"sky(sun)", "temperature(18.0)"});
    Expect("0.0", "0.0", "10.0");
    Soil("0.6", "0.6");
    Be("b1", "40.0");
    mind_.Decide();
    Be("b2", "40.0");
    mind_.Decide();
    Be("well", "");
    Stock("40.0", "400.0");
  }
  void At(int day, const std::string& hour) {
    mind_.Latch("clock", {"day(" + std::to_string(day) + ")", "hour(" + hour + ")", "working"});
  }
  void Expect(const std::string& today, const std::string& tomorrow, const std::string& low) {
    mind_.Latch("forecast", {"rain_expected(0, " + today + ")",
                             "rain_expected(1, " + tomorrow + ")", "low_expected(" + low + ")"});
  }
  void Soil(const std::string& b1, const std::string& b2, std::vector<std::string> more = {}) {
    more.push_back("soil(b1, " + b1 + ")");
    more.push_back("soil(b2, " + b2 + ")");
    mind_.Latch("beds", more);
  }
  void Be(const std::string& place, const std::string& food) {
    std::vector<std::string> seen = {"at(" + place + ")"};
    if (!food.empty()) seen.push_back("food(" + place + ", " + food + ")");
    mind_.Latch("inspection", seen);
  }
  void Stock(const std::string& tank, const std::string& barrel, int portions = 9) {
    mind_.Latch("stock", {"tank(" + tank + ")", "barrel(" + barrel + ")",
                          "portions(" + std::to_string(portions) + ")"});
  }

  LayerMind mind_{"gardener", {}, kIcarusMind};
};

TEST_F(GardenerLayerTest, AllWell_Rests) { EXPECT_THAT(mind_.Decide(), IsEmpty()); }

TEST_F(GardenerLayerTest, Night_Rests) {
  Soil("0.2", "0.2");
  mind_.Latch("clock", {"day(20)", "hour(2.0)"});
  EXPECT_THAT(mind_.Decide(), IsEmpty());
}

TEST_F(GardenerLayerTest, ThirstiestBed_IsWateredFirst) {
  Soil("0.45", "0.4");
  EXPECT_THAT(mind_.Decide(), ElementsAre("walk(b2)"));
  Be("b2", "40.0");
  EXPECT_THAT(mind_.Decide(), ElementsAre("pour"));
  Soil("0.45", "0.55");
  EXPECT_THAT(mind_.Decide(), ElementsAre("pour")) << "not yet enough";
  Soil("0.45", "0.63");
  EXPECT_THAT(mind_.Decide(), ElementsAre("walk(b1)"));
}

TEST_F(GardenerLayerTest, EmptyTank_IsFilledAtTheWell) {
  Soil("0.45", "0.6");
  Be("b1", "40.0");
  Stock("0.0", "400.0");
  EXPECT_THAT(mind_.Decide(), ElementsAre("walk(well)"));
  Be("well", "");
  EXPECT_THAT(mind_.Decide(), ElementsAre("fill"));
  Stock("20.0", "380.0");
  EXPECT_THAT(mind_.Decide(), ElementsAre("fill")) << "until it is full";
}

TEST_F(GardenerLayerTest, RainTomorrow_SavesTheWalk) {
  Soil("0.45", "0.6");
  Expect("0.0", "20.0", "10.0");
  EXPECT_THAT(mind_.Decide(), IsEmpty());
}

TEST_F(GardenerLayerTest, Raining_NothingIsWatered) {
  Soil("0.3", "0.3");
  mind_.Latch("weather", {"sky(rain)", "temperature(18.0)"});
  EXPECT_THAT(mind_.Decide(), IsEmpty());
}

TEST_F(GardenerLayerTest, FrostForecast_CoversInTheAfternoon) {
  Expect("0.0", "0.0", "0.5");
  EXPECT_THAT(mind_.Decide(), IsEmpty()) << "in the morning there is time";
  At(20, "16.5");
  EXPECT_THAT(mind_.Decide(), ElementsAre("walk(b1)"));
  Be("b1", "40.0");
  EXPECT_THAT(mind_.Decide(), ElementsAre("cover"));
  Soil("0.6", "0.6", {"covered(b1)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre("walk(b2)"));
}

TEST_F(GardenerLayerTest, WarmMorning_Uncovers) {
  Soil("0.6", "0.6", {"covered(b2)"});
  Be("b2", "40.0");
  EXPECT_THAT(mind_.Decide(), ElementsAre("uncover"));
  mind_.Latch("weather", {"sky(sun)", "temperature(1.0)"});
  EXPECT_THAT(mind_.Decide(), IsEmpty()) << "still too cold";
}

TEST_F(GardenerLayerTest, FloodForecast_CoversTheWetBed) {
  Soil("0.75", "0.4");
  Expect("20.0", "0.0", "10.0");
  EXPECT_THAT(mind_.Decide(), ElementsAre("walk(b1)"));
}

TEST_F(GardenerLayerTest, NoWaterLeft_ShadesWhatIsParched) {
  Soil("0.25", "0.6");
  Stock("0.0", "3.0");
  Be("b1", "40.0");
  EXPECT_THAT(mind_.Decide(), ElementsAre("cover"));
}

TEST_F(GardenerLayerTest, HungryBed_IsFed) {
  Be("b1", "20.0");
  EXPECT_THAT(mind_.Decide(), ElementsAre("feed"));
  Stock("40.0", "400.0", 0);
  EXPECT_THAT(mind_.Decide(), IsEmpty()) << "nothing left to feed it with";
}

TEST_F(GardenerLayerTest, LongNotSeen_IsLookedAt) {
  At(24, "9.0");
  EXPECT_THAT(mind_.Decide(), ElementsAre("walk(b1)"));
  Be("b1", "40.0");
  EXPECT_THAT(mind_.Decide(), ElementsAre("walk(b2)")) << "it is well";
}

}  // namespace
}  // namespace latchwork::test

// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/plugins/layer_mind.h"

namespace latchwork::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class SeekTest : public ::testing::TestWithParam<const char*> {
 protected:
  SeekTest() { mind_.Latch("pose", {"curr_location(1.0, 1.0)", "curr_heading(0.0)"}); }
  LayerMind mind_{"seek", {}, GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Reasoners, SeekTest,
                         ::testing::Values("pttp", "circumscription", "icarus"), ReasonerName);

TEST_P(SeekTest, NoDestination_Silent) { EXPECT_THAT(mind_.Decide(), IsEmpty()); }

TEST_P(SeekTest, DestinationAhead_PushedFromBehind) {
  mind_.Latch("destination", {"move_cmd(5.0, 1.2)"});
  EXPECT_THAT(mind_.Decide(), ElementsAre(StartsWith("direction(push_object, 3.14159"),
                                          "distance(push_object, 1.0)", "object(push_object)"));
}

TEST_P(SeekTest, DestinationToTheLeft_PushedFromTheRight) {
  mind_.Latch("destination", {"move_cmd(1.0, 5.0)"});
  EXPECT_THAT(mind_.Decide()[0], StartsWith("direction(push_object, -1.5707"));
}

TEST_P(SeekTest, DestinationToTheRight_PushedFromTheLeft) {
  mind_.Latch("destination", {"move_cmd(1.0, -5.0)"});
  EXPECT_THAT(mind_.Decide()[0], StartsWith("direction(push_object, 1.5707"));
}

TEST_P(SeekTest, DestinationReached_Silent) {
  mind_.Latch("destination", {"move_cmd(1.1, 1.0)"});
  EXPECT_THAT(mind_.Decide(), IsEmpty());
}

TEST_P(SeekTest, DestinationTakenBack_SilentAgain) {
  mind_.Latch("destination", {"move_cmd(5.0, 1.0)"});
  EXPECT_EQ(mind_.Decide().size(), 3U);
  mind_.Latch("destination", {});
  EXPECT_THAT(mind_.Decide(), IsEmpty());
}

TEST_P(SeekTest, TwoDestinations_SecondRefused) {
  EXPECT_THAT(mind_.Refused("destination", {"move_cmd(5.0, 1.0)", "move_cmd(4.0, 1.0)"}),
              ElementsAre(1));
  EXPECT_THAT(mind_.Refused("destination", {"move_cmd(5.0, 1.0)", "move_cmd(5.0, 2.0)"}),
              ElementsAre(1));
  EXPECT_THAT(mind_.Refused("destination", {"move_cmd(5.0, 1.0)"}), IsEmpty());
}

TEST_P(SeekTest, MoreSectors_FinerPush) {
  LayerMind mind("seek", {{"sectors", "32", {}}}, GetParam());
  mind.Latch("pose", {"curr_location(0.0, 0.0)", "curr_heading(0.0)"});
  mind.Latch("destination", {"move_cmd(10.0, 2.0)"});
  EXPECT_THAT(mind.Decide()[0], StartsWith("direction(push_object, -2.9452"));
}

}  // namespace
}  // namespace latchwork::test

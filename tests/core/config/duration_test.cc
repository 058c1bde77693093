// SPDX-License-Identifier: BSD-3-Clause
#include "core/config/duration.h"

#include <gtest/gtest.h>

namespace latchwork::config {
namespace {

TEST(DurationTest, ReadsEveryUnit) {
  EXPECT_EQ(ParseDuration("5us"), 5U);
  EXPECT_EQ(ParseDuration("100ms"), 100'000U);
  EXPECT_EQ(ParseDuration("1.5s"), 1'500'000U);
  EXPECT_EQ(ParseDuration("2min"), 120'000'000U);
  EXPECT_EQ(ParseDuration("999999999h"), 3'599'999'996'400'000'000U);
}

TEST(DurationTest, RefusesWhatIsNone) {
  for (const char* text :
       {"", "5", "s", "1.s", ".5s", "-1s", "1 s", "0.5us", "1000000000s", "1e3s"}) {
    EXPECT_EQ(ParseDuration(text), std::nullopt) << text;
  }
}

TEST(DurationTest, FormatsInTheLargestWholeUnit) {
  EXPECT_EQ(FormatDuration(2'000'000), "2s");
  EXPECT_EQ(FormatDuration(1'500'000), "1500ms");
  EXPECT_EQ(FormatDuration(7), "7us");
}

}  // namespace
}  // namespace latchwork::config

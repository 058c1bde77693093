// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/garden/weather.h"

#include <gtest/gtest.h>

#include <cmath>

namespace latchwork::garden {
namespace {

constexpr int kDays = 70;

TEST(WeatherTest, Rain_AddsUpToWhatTheDaySays) {
  const Weather weather(3, kDays);
  int wet = 0;
  for (int day = 0; day < kDays; ++day) {
    double sum = 0;
    for (int minute = 0; minute < 24 * 60; ++minute) {
      sum += weather.Rain(24.0 * day + (minute + 0.5) / 60) / 60;
    }
    EXPECT_NEAR(sum, weather.OfDay(day).rain, 1e-6);
    wet += weather.OfDay(day).rain > 0 ? 1 : 0;
  }
  EXPECT_GT(wet, 5);
}

TEST(WeatherTest, Temperature_IsLowestAtFiveAndContinuous) {
  const Weather weather(5, kDays);
  for (int day = 0; day < kDays; ++day) {
    EXPECT_NEAR(weather.Temperature(24.0 * day + 5), weather.OfDay(day).low, 1e-9);
    EXPECT_NEAR(weather.Temperature(24.0 * day + 15), weather.OfDay(day).high, 1e-9);
  }
  for (double hour = 30; hour < 24.0 * kDays - 30; hour += 0.05) {
    EXPECT_LT(std::abs(weather.Temperature(hour + 0.05) - weather.Temperature(hour)), 0.5);
  }
}

TEST(WeatherTest, Nights_AreColdAtTheEndsOfTheSeason) {
  int ends = 0;
  int middle = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Weather weather(seed, kDays);
    for (int day = 1; day < 6; ++day) {
      ends += weather.OfDay(day).low < 0 ? 1 : 0;
      ends += weather.OfDay(kDays - day).low < 0 ? 1 : 0;
    }
    for (int day = 30; day < 40; ++day) middle += weather.OfDay(day).low < 0 ? 1 : 0;
  }
  EXPECT_GT(ends, 10);
  EXPECT_EQ(middle, 0);
}

TEST(WeatherTest, NightBeforeTheFirstDay_HasNoFrost) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    EXPECT_GE(Weather(seed, kDays).OfDay(0).low, 0) << "seed " << seed;
  }
}

TEST(WeatherTest, Drought_BringsNoRain) {
  int days = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Weather weather(seed, kDays);
    for (int day = 0; day < kDays; ++day) {
      if (!weather.OfDay(day).drought) continue;
      ++days;
      EXPECT_EQ(weather.OfDay(day).rain, 0);
    }
  }
  EXPECT_GT(days, 50);
}

TEST(WeatherTest, Forecast_ErrsALittle) {
  double error = 0;
  int exact = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Weather weather(seed, kDays);
    for (int day = 0; day < kDays; ++day) {
      const Forecast forecast = weather.ForecastAt(24.0 * day + 12);
      const double miss = std::abs(forecast.low_tonight - weather.OfDay(day + 1).low);
      error += miss / (10 * kDays);
      exact += miss == 0 ? 1 : 0;
      EXPECT_GE(forecast.rain_tomorrow, 0);
    }
  }
  EXPECT_GT(error, 0.4);
  EXPECT_LT(error, 1.0);
  EXPECT_EQ(exact, 0);
}

TEST(WeatherTest, SameSeed_SameSeason) {
  const Weather a(9, kDays);
  const Weather b(9, kDays);
  const Weather c(10, kDays);
  EXPECT_EQ(a.OfDay(33).low, b.OfDay(33).low);
  EXPECT_NE(a.OfDay(33).low, c.OfDay(33).low);
}

TEST(WeatherTest, Night_IsDark) {
  const Weather weather(1, kDays);
  EXPECT_EQ(weather.Light(24 * 10 + 2), 0);
  EXPECT_GT(weather.Light(24 * 10 + 13), 0.3);
}

}  // namespace
}  // namespace latchwork::garden

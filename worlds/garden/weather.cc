// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/garden/weather.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "latchwork/sdk/random.h"

namespace latchwork::garden {

namespace {

/// A kind of spell: how long it goes on, and what its days are like.
struct Spell {
  double goes_on;  ///< Chance, from day to day.
  double rain_chance;
  double rain_mean;  ///< mm of a day with rain
  double warmer;     ///< °C
};

constexpr std::array<Spell, 3> kSpells = {
    {{0.75, 0.2, 8, 0}, {0.7, 0.7, 13, -2}, {0.82, 0.0, 0, 5}}};
constexpr std::size_t kDrought = 2;
constexpr double kColdHour = 5;
constexpr double kWarmHour = 15;

double Between(double low, double high, double part) { return low + (high - low) * part; }

/// 0 to 1 and smooth.
double Rise(double part) { return 0.5 - 0.5 * std::cos(std::numbers::pi * part); }

int DayOf(double hour) { return static_cast<int>(std::floor(hour / 24)); }

}  // namespace

Weather::Weather(std::uint64_t seed, int days) {
  const sdk::RandomStream random(seed, "weather");
  std::size_t spell = 0;
  double swing = 0;  // °C of the nights against the season's mean
  for (int day = 0; day <= days + 1; ++day) {
    const auto k = static_cast<std::uint64_t>(day);
    if (random.Uniform(k, 0) >= kSpells.at(spell).goes_on) spell = random.Index(3, k, 1);
    const Spell& now = kSpells.at(spell);
    const double season = std::sin(std::numbers::pi * day / days);
    swing = 0.6 * swing + 2.0 * random.Gaussian(k, 1);
    Day made;
    made.drought = spell == kDrought;
    made.low = 2.5 + 11 * season + swing;
    // Nobody works in the night before the first day: the season begins after the frost.
    if (day == 0) made.low = std::max(made.low, 0.0);
    made.high = made.low + 9 + now.warmer + 2 * random.Uniform(k, 4);
    if (random.Uniform(k, 5) < now.rain_chance) {
      made.rain = std::min(60.0, -now.rain_mean * std::log(1 - random.Uniform(k, 6)));
      made.rain_hours = 2 + std::floor(8 * random.Uniform(k, 7));
      made.rain_begins = std::floor((24 - made.rain_hours) * random.Uniform(k, 8));
    }
    const bool dull = made.rain > 0 || (!made.drought && random.Uniform(k, 9) < 0.4);
    made.sky = dull ? Sky::kCloud : Sky::kSun;
    days_.push_back(made);
  }
  for (int day = 0; day <= days; ++day) {
    const auto k = static_cast<std::uint64_t>(day);
    const auto expect = [&](double rain, std::uint64_t n) {
      return std::max(0.0, rain * random.Between(0.7, 1.3, k, n) + 1.5 * random.Gaussian(k, n));
    };
    forecasts_.push_back({expect(OfDay(day).rain, 20), expect(OfDay(day + 1).rain, 22),
                          OfDay(day + 1).low + 0.8 * random.Gaussian(k, 24)});
  }
}

const Day& Weather::OfDay(int day) const {
  return days_[std::min(static_cast<std::size_t>(std::max(day, 0)), days_.size() - 1)];
}

Sky Weather::SkyAt(double hour) const {
  return Rain(hour) > 0 ? Sky::kRain : OfDay(DayOf(hour)).sky;
}

double Weather::Temperature(double hour) const {
  const int day = DayOf(hour);
  const double clock = hour - 24.0 * day;
  if (clock < kColdHour) {
    const double part = (clock + 24 - kWarmHour) / (24 - kWarmHour + kColdHour);
    return Between(OfDay(day - 1).high, OfDay(day).low, Rise(part));
  }
  if (clock < kWarmHour) {
    const double part = (clock - kColdHour) / (kWarmHour - kColdHour);
    return Between(OfDay(day).low, OfDay(day).high, Rise(part));
  }
  const double part = (clock - kWarmHour) / (24 - kWarmHour + kColdHour);
  return Between(OfDay(day).high, OfDay(day + 1).low, Rise(part));
}

double Weather::Light(double hour) const {
  constexpr double kSunrise = 5;
  constexpr double kSunset = 21;
  const double clock = hour - 24.0 * DayOf(hour);
  if (clock <= kSunrise || clock >= kSunset) return 0;
  const double high = std::sin(std::numbers::pi * (clock - kSunrise) / (kSunset - kSunrise));
  constexpr std::array<double, 3> kThrough = {1.0, 0.6, 0.4};
  return high * kThrough.at(static_cast<std::size_t>(SkyAt(hour)));
}

double Weather::Rain(double hour) const {
  const Day& day = OfDay(DayOf(hour));
  const double since = hour - 24.0 * DayOf(hour) - day.rain_begins;
  return day.rain > 0 && since >= 0 && since < day.rain_hours ? day.rain / day.rain_hours : 0;
}

Forecast Weather::ForecastAt(double hour) const {
  const auto day = static_cast<std::size_t>(std::max(DayOf(hour), 0));
  return forecasts_[std::min(day, forecasts_.size() - 1)];
}

}  // namespace latchwork::garden

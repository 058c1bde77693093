// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_GARDEN_WEATHER_H_
#define LATCHWORK_GARDEN_WEATHER_H_

#include <cstdint>
#include <vector>

namespace latchwork::garden {

enum class Sky : std::uint8_t { kSun, kCloud, kRain };

/// The weather of a day, in its own terms.
struct Day {
  Sky sky = Sky::kSun;     ///< But for the hours of rain, when it rains.
  bool drought = false;    ///< Of a long hot spell without rain.
  double rain = 0;         ///< mm in the whole day
  double rain_begins = 0;  ///< hour
  double rain_hours = 0;
  double low = 0;   ///< °C, at five in the morning
  double high = 0;  ///< °C, at three in the afternoon
};

/// What the forecast says.
struct Forecast {
  double rain_today = 0;     ///< mm
  double rain_tomorrow = 0;  ///< mm
  double low_tonight = 0;    ///< °C, of the coming night
};

/// The weather of a season, by seed: spells of fair, wet and dry days; nights that are cold at its
/// beginning and at its end. Hours count from the midnight before the first day.
class Weather {
 public:
  Weather(std::uint64_t seed, int days);

  const Day& OfDay(int day) const;
  Sky SkyAt(double hour) const;
  double Temperature(double hour) const;  ///< °C
  double Light(double hour) const;        ///< 0 to 1
  double Rain(double hour) const;         ///< mm/h
  /// Errs by some millimetres and about a degree; the same all day.
  Forecast ForecastAt(double hour) const;

 private:
  std::vector<Day> days_;
  std::vector<Forecast> forecasts_;
};

}  // namespace latchwork::garden

#endif  // LATCHWORK_GARDEN_WEATHER_H_

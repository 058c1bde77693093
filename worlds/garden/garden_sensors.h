// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_GARDEN_GARDEN_SENSORS_H_
#define LATCHWORK_GARDEN_GARDEN_SENSORS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/random.h"
#include "latchwork/sdk/world.h"
#include "worlds/garden/garden_state.h"

namespace latchwork::garden {

/// Turns the state of the garden into what the gardener senses.
class GardenSensors {
 public:
  GardenSensors(double probe_noise, std::uint64_t seed, const GardenState& state,
                logic::SymbolTable& symbols);

  void Observe(std::uint64_t tick, const GardenState& state, std::span<sdk::Batch> sensors);

 private:
  using Facts = std::vector<logic::Fact>;

  void SayMap(const GardenState& state, Facts& facts) const;
  void SayClock(const GardenState& state, Facts& facts) const;
  void SayWeather(const GardenState& state, Facts& facts) const;
  void SayForecast(const GardenState& state, Facts& facts) const;
  void SayBeds(std::uint64_t tick, const GardenState& state, Facts& facts) const;
  void SayInspection(const GardenState& state, Facts& facts) const;
  void SayStock(const GardenState& state, Facts& facts) const;

  double probe_noise_;
  sdk::RandomStream probe_random_;
  std::vector<logic::Term> names_;  ///< Of the beds.
  int said_day_ = -1;
  logic::Symbol bed_, day_, hour_, working_, sky_, sun_, cloud_, rain_, temperature_,
      rain_expected_, low_expected_, soil_, covered_, at_, well_, food_, pumpkin_, tank_, barrel_,
      portions_;
};

}  // namespace latchwork::garden

#endif  // LATCHWORK_GARDEN_GARDEN_SENSORS_H_

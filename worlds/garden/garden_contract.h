// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_GARDEN_GARDEN_CONTRACT_H_
#define LATCHWORK_GARDEN_GARDEN_CONTRACT_H_

#include <cstddef>
#include <vector>

#include "latchwork/sdk/contract.h"

namespace latchwork::garden {

/// The places of the ports in the contract.
enum SensorPort : std::size_t {
  kMap,
  kClock,
  kWeather,
  kForecast,
  kBeds,
  kInspection,
  kStock,
  kSensorPorts
};
enum EffectorPort : std::size_t { kWork, kEffectorPorts };

sdk::Contract GardenContract();
std::vector<sdk::PredicateSpec> GardenEvents();
std::vector<sdk::ParameterSpec> GardenParameters();

}  // namespace latchwork::garden

#endif  // LATCHWORK_GARDEN_GARDEN_CONTRACT_H_

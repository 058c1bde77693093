// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_BUMPER_CARS_BUMPER_CONTRACT_H_
#define LATCHWORK_BUMPER_CARS_BUMPER_CONTRACT_H_

#include <cstddef>
#include <vector>

#include "latchwork/sdk/contract.h"

namespace latchwork::bumper_cars {

/// Indices of the ports in the contract.
enum SensorPort : std::size_t {
  kTask,
  kPlaces,
  kPeople,
  kSelf,
  kEyes,
  kFeelers,
  kTouchPort,
  kScore,
  kSensorPorts
};
enum EffectorPort : std::size_t { kDrive, kGate, kEffectorPorts };

sdk::Contract BumperContract();
std::vector<sdk::ParameterSpec> BumperParameters();
std::vector<sdk::PredicateSpec> BumperEvents();

}  // namespace latchwork::bumper_cars

#endif  // LATCHWORK_BUMPER_CARS_BUMPER_CONTRACT_H_

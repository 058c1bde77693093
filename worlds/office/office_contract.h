// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_OFFICE_CONTRACT_H_
#define LATCHWORK_OFFICE_OFFICE_CONTRACT_H_

#include <cstddef>
#include <vector>

#include "latchwork/sdk/contract.h"

namespace latchwork::office {

/// The places of the ports in the contract.
enum SensorPort : std::size_t {
  kSonar,
  kRobot,
  kPose,
  kPlace,
  kBuilding,
  kElevators,
  kDoors,
  kGoal,
  kDestination,
  kSensorPorts
};
enum EffectorPort : std::size_t { kDrive, kButtons, kEffectorPorts };

sdk::Contract OfficeContract();
std::vector<sdk::PredicateSpec> OfficeEvents();
std::vector<sdk::ParameterSpec> OfficeParameters();

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_OFFICE_CONTRACT_H_

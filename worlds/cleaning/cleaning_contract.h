// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CLEANING_CLEANING_CONTRACT_H_
#define LATCHWORK_CLEANING_CLEANING_CONTRACT_H_

#include <cstddef>
#include <vector>

#include "latchwork/sdk/contract.h"

namespace latchwork::cleaning {

/// The places of the ports in the contract.
enum SensorPort : std::size_t { kRobot, kPose, kView, kRanges, kTouch, kPower, kSensorPorts };
enum EffectorPort : std::size_t { kDrive, kEffectorPorts };

sdk::Contract CleaningContract();
std::vector<sdk::PredicateSpec> CleaningEvents();
std::vector<sdk::ParameterSpec> CleaningParameters();

}  // namespace latchwork::cleaning

#endif  // LATCHWORK_CLEANING_CLEANING_CONTRACT_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TRAFFIC_TRAFFIC_CONTRACT_H_
#define LATCHWORK_TRAFFIC_TRAFFIC_CONTRACT_H_

#include <cstddef>
#include <vector>

#include "latchwork/sdk/contract.h"

namespace latchwork::traffic {

/// The places of the ports in the contract.
enum SensorPort : std::size_t { kSelf, kCars, kRoad, kReward, kSensorPorts };
enum EffectorPort : std::size_t { kDrive, kEffectorPorts };

sdk::Contract TrafficContract();
std::vector<sdk::PredicateSpec> TrafficEvents();
std::vector<sdk::ParameterSpec> TrafficParameters();

}  // namespace latchwork::traffic

#endif  // LATCHWORK_TRAFFIC_TRAFFIC_CONTRACT_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_HANOI_HANOI_CONTRACT_H_
#define LATCHWORK_HANOI_HANOI_CONTRACT_H_

#include <cstddef>
#include <vector>

#include "latchwork/sdk/contract.h"

namespace latchwork::hanoi {

/// Indices of the ports in the contract.
enum SensorPort : std::size_t { kTask, kCamera, kGripper, kSensorPorts };

sdk::Contract HanoiContract();
std::vector<sdk::ParameterSpec> HanoiParameters();
std::vector<sdk::PredicateSpec> HanoiEvents();

}  // namespace latchwork::hanoi

#endif  // LATCHWORK_HANOI_HANOI_CONTRACT_H_

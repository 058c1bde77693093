// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CART_POLE_CART_POLE_CONTRACT_H_
#define LATCHWORK_CART_POLE_CART_POLE_CONTRACT_H_

#include <cstddef>
#include <vector>

#include "latchwork/sdk/contract.h"

namespace latchwork::cart_pole {

/// The places of the ports in the contract.
enum SensorPort : std::size_t { kMotion, kTrack, kSensorPorts };
enum EffectorPort : std::size_t { kMotor, kEffectorPorts };

sdk::Contract CartPoleContract();
std::vector<sdk::PredicateSpec> CartPoleEvents();
std::vector<sdk::ParameterSpec> CartPoleParameters();

}  // namespace latchwork::cart_pole

#endif  // LATCHWORK_CART_POLE_CART_POLE_CONTRACT_H_

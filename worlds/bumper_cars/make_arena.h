// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_BUMPER_CARS_MAKE_ARENA_H_
#define LATCHWORK_BUMPER_CARS_MAKE_ARENA_H_

#include <cstdint>

#include "latchwork/sdk/parameters.h"
#include "worlds/bumper_cars/arena.h"
#include "worlds/bumper_cars/referee.h"

namespace latchwork::bumper_cars {

/// The arena of the parameters: the agent at the gate, the others anywhere, by seed, but not upon
/// each other where there is room.
Arena MakeArena(const sdk::Parameters& parameters, std::uint64_t seed);

Rules MakeRules(const sdk::Parameters& parameters);

}  // namespace latchwork::bumper_cars

#endif  // LATCHWORK_BUMPER_CARS_MAKE_ARENA_H_

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "worlds/garden/garden_world.h"

LATCHWORK_PLUGIN(latchwork::garden::GardenWorld, "garden", "0.1.0",
                 "a season in a garden of pumpkins that compete, with weather and a forecast")

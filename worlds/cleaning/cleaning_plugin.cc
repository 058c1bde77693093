// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "worlds/cleaning/cleaning_world.h"

LATCHWORK_PLUGIN(latchwork::cleaning::CleaningWorld, "cleaning", "0.1.0",
                 "a robot with a brush and a battery on a floor of offices")

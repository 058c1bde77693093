// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "worlds/bumper_cars/bumper_world.h"

LATCHWORK_PLUGIN(latchwork::bumper_cars::BumperWorld, "bumper_cars", "0.1.0",
                 "an arena of bumper cars with friends, enemies and power poles")

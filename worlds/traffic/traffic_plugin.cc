// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "worlds/traffic/traffic_world.h"

LATCHWORK_PLUGIN(latchwork::traffic::TrafficWorld, "traffic", "0.1.0",
                 "a car among others on a road of several lanes: keep lane, follow, pass, exit")

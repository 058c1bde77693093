// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "plugins/elevators/elevators_layer.h"

LATCHWORK_PLUGIN(latchwork::elevators::ElevatorsLayer, "elevators", "0.1.0",
                 "layer 2: plans on foot and by elevator to the next landmark")

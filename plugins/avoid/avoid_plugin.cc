// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "plugins/avoid/avoid_layer.h"

LATCHWORK_PLUGIN(latchwork::avoid::AvoidLayer, "avoid", "0.1.0",
                 "layer 0: sonar echoes and virtual objects become a turn, a step or a halt")

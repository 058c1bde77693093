// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "plugins/seek/seek_layer.h"

LATCHWORK_PLUGIN(latchwork::seek::SeekLayer, "seek", "0.1.0",
                 "layer 1: a destination becomes a virtual object that pushes the robot")

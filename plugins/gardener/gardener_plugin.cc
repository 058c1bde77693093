// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "plugins/gardener/gardener_layer.h"

LATCHWORK_PLUGIN(latchwork::gardener::GardenerLayer, "gardener", "0.1.0",
                 "tends pumpkins: shelters, waters and feeds them as weather and soil ask for")

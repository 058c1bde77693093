// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "plugins/itinerary/itinerary_layer.h"

LATCHWORK_PLUGIN(latchwork::itinerary::ItineraryLayer, "itinerary", "0.1.0",
                 "layer 3: plans over landmarks which one comes next")

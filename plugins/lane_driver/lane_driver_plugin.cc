// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "plugins/lane_driver/lane_driver_layer.h"

LATCHWORK_PLUGIN(latchwork::lane_driver::LaneDriverLayer, "lane_driver", "0.1.0",
                 "drives a car in traffic: keeps its lane, follows, passes, takes its exit")

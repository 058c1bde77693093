// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "plugins/pole_balancer/pole_balancer_layer.h"

LATCHWORK_PLUGIN(latchwork::pole_balancer::PoleBalancerLayer, "pole_balancer", "0.1.0",
                 "keeps a pole on a cart upright and the cart in the middle of its track")

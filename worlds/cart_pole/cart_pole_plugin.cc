// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "worlds/cart_pole/cart_pole_world.h"

LATCHWORK_PLUGIN(latchwork::cart_pole::CartPoleWorld, "cart_pole", "0.1.0",
                 "a pole on a cart on a track with ends, to be kept upright")

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "worlds/hanoi/hanoi_world.h"

LATCHWORK_PLUGIN(latchwork::hanoi::HanoiWorld, "hanoi", "0.1.0",
                 "the Tower of Hanoi with a gripper, and a hand that interferes")

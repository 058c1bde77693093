// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "plugins/hanoi_player/hanoi_player_layer.h"

LATCHWORK_PLUGIN(latchwork::hanoi_player::HanoiPlayerLayer, "hanoi_player", "0.1.0",
                 "plays the Tower of Hanoi, from any position, whatever happens to the disks")

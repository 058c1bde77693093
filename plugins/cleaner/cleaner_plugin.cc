// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "plugins/cleaner/cleaner_layer.h"

LATCHWORK_PLUGIN(latchwork::cleaner::CleanerLayer, "cleaner", "0.1.0",
                 "cleans a floor, recharges in time and goes home when nothing is left to clean")

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "plugins/bumper_driver/bumper_driver_layer.h"

LATCHWORK_PLUGIN(latchwork::bumper_driver::BumperDriverLayer, "bumper_driver", "0.1.0",
                 "drives a bumper car: rams enemies, taps friends, has a day of it")

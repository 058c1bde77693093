// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "worlds/office/office_world.h"

LATCHWORK_PLUGIN(latchwork::office::OfficeWorld, "office", "0.1.0",
                 "a simulated office building: floors, sonar, elevators, doors, people")

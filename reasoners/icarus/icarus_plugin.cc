// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "reasoners/icarus/icarus_reasoner.h"

LATCHWORK_PLUGIN(latchwork::icarus::IcarusReasoner, "icarus", "0.1.0",
                 "an interpreter of Icarus programs: skills, rechecked in every cycle")

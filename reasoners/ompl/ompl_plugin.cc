// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "reasoners/ompl/ompl_reasoner.h"

LATCHWORK_PLUGIN(latchwork::planning::OmplReasoner, "ompl", "0.1.0",
                 "sampling-based planners over the map of a building")

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "reasoners/brooks/brooks_reasoner.h"

LATCHWORK_PLUGIN(latchwork::brooks::BrooksReasoner, "brooks", "0.1.0",
                 "plain reactive behaviours in place of a reasoner: avoid, wander, explore")

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "reasoners/pttp/pttp_reasoner.h"

LATCHWORK_PLUGIN(latchwork::pttp::PttpReasoner, "pttp", "0.1.0",
                 "a model-elimination theorem prover for theories in TPTP syntax")

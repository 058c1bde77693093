// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "reasoners/eprover/eprover_reasoner.h"

LATCHWORK_PLUGIN(latchwork::eprover::EproverReasoner, "eprover", "0.1.0",
                 "theories in TPTP syntax without arithmetic, decided by the prover E")

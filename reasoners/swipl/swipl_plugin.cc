// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "reasoners/swipl/swipl_reasoner.h"

LATCHWORK_PLUGIN(latchwork::swipl::SwiplReasoner, "swipl", "0.1.0",
                 "theories in TPTP syntax as Prolog programs, run by SWI-Prolog")

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"
#include "reasoners/circumscription/circumscription_reasoner.h"

LATCHWORK_PLUGIN(latchwork::circumscription::CircumscriptionReasoner, "circumscription", "0.1.0",
                 "circumscription of theories in TPTP syntax, exact or by bounded proof")

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_EXPLAIN_ACT_H_
#define LATCHWORK_ICARUS_EXPLAIN_ACT_H_

#include "latchwork/logic/atom.h"
#include "latchwork/sdk/decision.h"
#include "reasoners/icarus/body/term_bridge.h"
#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/interpreter.h"

namespace latchwork::icarus {

/// How an act came about that `conclusion` stands for: the skills from the top to the action, each
/// with its arguments, where it was called.
sdk::Derivation ExplainAct(const Act& act, const logic::Fact& conclusion, const Program& program,
                           TermBridge& bridge);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_EXPLAIN_ACT_H_

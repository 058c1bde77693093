// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_LAYER_CHECK_H_
#define LATCHWORK_ICARUS_LAYER_CHECK_H_

#include <string>
#include <vector>

#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/reasoner.h"
#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"

namespace latchwork::icarus {

/// How the facts begin, folded, that the inputs and parameters of a layer bring: for
/// CheckOptions::facts.
std::vector<std::string> FactsOf(const sdk::Body& body);

/// What is wrong with a program, which has no errors by itself, as the body of a layer: functions,
/// acts and facts that its contract, attachments and parameters do not have, and a missing top.
Findings CheckInLayer(const Program& program, const sdk::Body& body, logic::SymbolTable& symbols);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_LAYER_CHECK_H_

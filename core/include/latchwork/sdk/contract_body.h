// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_CONTRACT_BODY_H_
#define LATCHWORK_SDK_CONTRACT_BODY_H_

#include <string_view>

#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/layer.h"
#include "latchwork/sdk/reasoner.h"

namespace latchwork::sdk {

/// What a contract says about a body, for Layer::MakeBody to add to: the latches may hold every
/// predicate of every input; every predicate of every output is a goal, of which the first proof
/// counts.
Body ContractBody(const Contract& contract, std::string_view language, logic::SymbolTable& symbols);

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_CONTRACT_BODY_H_

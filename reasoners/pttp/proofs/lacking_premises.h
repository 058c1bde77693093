// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_LACKING_PREMISES_H_
#define LATCHWORK_PTTP_LACKING_PREMISES_H_

#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/explanation.h"
#include "reasoners/pttp/search/engine.h"

namespace latchwork::pttp {

/// Why no instance of `target` is proved: for each clause that could conclude one, how many of its
/// premises are proved together, taken in their order, and the first that is not proved with them;
/// the nearest clause first. A clause that lacks none lacks depth. For reports: searches again and
/// spends no more than the budget for all of it.
std::vector<sdk::NearMiss> LackingPremises(const logic::Atom& target, const sdk::Budget& budget,
                                           Engine& engine, logic::SymbolTable& symbols);

/// The number of the highest variable and one; 0: ground.
std::size_t VariablesOf(const logic::Atom& atom);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_LACKING_PREMISES_H_

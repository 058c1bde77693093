// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_CORE_LOGIC_FINITE_MODELS_H_
#define LATCHWORK_TESTS_CORE_LOGIC_FINITE_MODELS_H_

#include <cstddef>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/formula.h"

namespace latchwork::logic {

/// Whether a formula as RandomFormula makes them (p/1, q/1, r/0, s/0) has a model of this size; by
/// trying all.
bool HasModel(const Formula& formula, std::size_t size);

/// Whether clauses have a model of this size. Function symbols may be applied to variables only.
bool HasModel(const std::vector<Clause>& clauses, std::size_t size);

}  // namespace latchwork::logic

#endif  // LATCHWORK_TESTS_CORE_LOGIC_FINITE_MODELS_H_

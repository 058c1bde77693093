// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_EXACT_REALS_H_
#define LATCHWORK_PTTP_EXACT_REALS_H_

#include <cstddef>

#include "latchwork/logic/arithmetic.h"
#include "reasoners/pttp/terms/calculator.h"

namespace latchwork::pttp {

/// Whether the shortest decimal numeral that is read as this double has its very value: 0.5 has,
/// 0.1 has not. Doubtful ones (beyond 2^53, or with more than 22 decimals) have not.
bool IsExactNumeral(double value);

/// Whether a function of integers and doubles is computed without rounding, as far as that is seen
/// at once. Sums, differences and products by error-free transformations (Knuth 1969, 4.2.2;
/// Dekker 1971).
bool IsExact(logic::Arithmetic::Function function, const Number* numbers, std::size_t arity);

/// Whether a function of numbers that were rounded when they were read still tells the truth.
bool AllowsRoundedNumerals(logic::Arithmetic::Function function, const Number* numbers,
                           std::size_t arity);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_EXACT_REALS_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_DECIMAL_H_
#define LATCHWORK_LOGIC_DECIMAL_H_

#include <string_view>

namespace latchwork::logic {

/// Whether two numerals, such as 0.5 and 5.0E-1, stand for the same number, however many digits
/// they have. Both are read as finite doubles.
bool AreEqualNumerals(std::string_view a, std::string_view b);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_DECIMAL_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_INTERPRETED_H_
#define LATCHWORK_LOGIC_INTERPRETED_H_

#include <array>
#include <cstddef>
#include <string_view>

namespace latchwork::logic {

struct InterpretedName {
  std::string_view name;
  std::size_t arity;
};

/// In the order of Arithmetic::Predicate.
inline constexpr std::array<InterpretedName, 6> kInterpretedPredicates = {{
    {"$less", 2},
    {"$lesseq", 2},
    {"$greater", 2},
    {"$greatereq", 2},
    {"$is_int", 1},
    {"$is_real", 1},
}};

/// In the order of Arithmetic::Function.
inline constexpr std::array<InterpretedName, 16> kInterpretedFunctions = {{
    {"$sum", 2},
    {"$difference", 2},
    {"$product", 2},
    {"$quotient", 2},
    {"$uminus", 1},
    {"$to_int", 1},
    {"$to_real", 1},
    {"$floor", 1},
    {"$ceiling", 1},
    {"$round", 1},
    {"$truncate", 1},
    {"$quotient_e", 2},
    {"$remainder_e", 2},
    {"$abs", 1},
    {"$min", 2},
    {"$max", 2},
}};

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_INTERPRETED_H_

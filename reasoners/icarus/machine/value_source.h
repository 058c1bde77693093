// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_VALUE_SOURCE_H_
#define LATCHWORK_ICARUS_VALUE_SOURCE_H_

#include <cstdint>
#include <optional>
#include <span>

#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

/// Where the values of skills without a :value come from.
class ValueSource {
 public:
  virtual ~ValueSource() = default;
  /// The value of a skill for these arguments; none among them: an unbound parameter; nothing: the
  /// skill has no value. Asked in the middle of a cycle, in which it gives the same answer to the
  /// same question.
  virtual std::optional<double> ValueOf(std::uint32_t skill, std::span<const Value> arguments) = 0;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_VALUE_SOURCE_H_

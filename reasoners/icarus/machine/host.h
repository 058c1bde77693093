// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_HOST_H_
#define LATCHWORK_ICARUS_HOST_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "reasoners/icarus/language/signature.h"
#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

/// What the interpreter's functions come from: the robot or world that a program runs on.
class Host {
 public:
  virtual ~Host() = default;

  /// The functions that a program may call, in an order that stays.
  virtual std::span<const Signature> functions() const = 0;
  /// What an :action may call, besides changes of memory; nothing: whatever it likes.
  virtual std::optional<std::span<const Signature>> acts() const { return std::nullopt; }
  /// The facts that the host writes into memory: names with their arguments. Others are not
  /// checked.
  virtual std::span<const Signature> facts() const { return {}; }
  /// What a person may do when a program calls a function that is none of them; may be empty.
  virtual std::string Remedy(std::string_view /*function*/) const { return {}; }
  /// The answer of `functions()[function]` for these ground arguments: none is False. Lists of the
  /// answer may be made in `arena`, names in `names`. Asked once per cycle for the same arguments,
  /// unless the function is declared to change memory. An exception is contained as a fault.
  virtual Value Call(std::size_t function, std::span<const Value> arguments, Arena& arena,
                     NamePool& names) = 0;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_HOST_H_

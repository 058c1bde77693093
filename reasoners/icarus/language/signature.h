// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_SIGNATURE_H_
#define LATCHWORK_ICARUS_SIGNATURE_H_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace latchwork::icarus {

enum class ArgumentType : std::uint8_t { kAny, kInteger, kNumber, kSymbol, kList };
/// With its article, "a number".
std::string_view NameOf(ArgumentType type);

inline constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

/// What a function takes, known before it is called.
struct Signature {
  std::string_view name;  ///< Folded.
  std::size_t least = 0;  ///< Arguments.
  std::size_t most = kAnyNumber;
  ArgumentType type = ArgumentType::kAny;  ///< Of every argument.
  bool changes_memory = false;
  std::span<const ArgumentType> types = {};  ///< Of each argument, where they differ.
  /// Of each value that it answers, several being a list and none being t; nothing: not known.
  std::optional<std::span<const ArgumentType>> answers = {};

  ArgumentType TypeOf(std::size_t argument) const {
    return argument < types.size() ? types[argument] : type;
  }
};

/// The functions that every program may call: {= a b}, {< a b}, {+ a b}, {member e list},
/// {store e}, {forget pattern}, {update pattern e}, …
std::span<const Signature> BuiltinSignatures();
/// The signature of a builtin; null when the host has to supply the function.
const Signature* FindBuiltin(std::string_view name);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_SIGNATURE_H_

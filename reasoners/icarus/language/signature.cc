// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/signature.h"

#include <algorithm>
#include <array>

namespace latchwork::icarus {

namespace {

constexpr ArgumentType kAny = ArgumentType::kAny;
constexpr ArgumentType kNumber = ArgumentType::kNumber;
constexpr std::array<ArgumentType, 2> kItemAndList = {kAny, ArgumentType::kList};

/// In the order of Builtin.
constexpr std::array<Signature, 19> kBuiltins = {{
    {"=", 2, 2, kAny, false},
    {"!=", 2, 2, kAny, false},
    {"<", 2, 2, kNumber, false},
    {"<=", 2, 2, kNumber, false},
    {">", 2, 2, kNumber, false},
    {">=", 2, 2, kNumber, false},
    {"+", 1, kAnyNumber, kNumber, false},
    {"-", 1, kAnyNumber, kNumber, false},
    {"*", 1, kAnyNumber, kNumber, false},
    {"/", 2, 2, kNumber, false},
    {"min", 1, kAnyNumber, kNumber, false},
    {"max", 1, kAnyNumber, kNumber, false},
    {"abs", 1, 1, kNumber, false},
    {"round", 1, 1, kNumber, false},
    {"list", 0, kAnyNumber, kAny, false},
    {"member", 2, 2, kAny, false, kItemAndList},
    {"store", 1, 1, kAny, true},
    {"forget", 1, 1, kAny, true},
    {"update", 2, 2, kAny, true},
}};

}  // namespace

std::string_view NameOf(ArgumentType type) {
  constexpr std::array<std::string_view, 5> kNames = {"a value", "an integer", "a number",
                                                      "a symbol", "a list"};
  return kNames.at(static_cast<std::size_t>(type));
}

std::span<const Signature> BuiltinSignatures() { return kBuiltins; }

const Signature* FindBuiltin(std::string_view name) {
  const auto* const found = std::find_if(kBuiltins.begin(), kBuiltins.end(),
                                         [&](const Signature& s) { return s.name == name; });
  return found == kBuiltins.end() ? nullptr : found;
}

}  // namespace latchwork::icarus

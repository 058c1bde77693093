// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/learning/feature.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace latchwork::icarus {

namespace {

constexpr double kLargest = 1e15;  // beyond this not every whole number is a double

Value Rounded(const Value& argument) {
  if (argument.kind != ValueKind::kReal) return argument;
  return Value::Integer(std::llround(std::clamp(argument.real, -kLargest, kLargest)));
}

}  // namespace

Value MakeFeature(const Value& argument, Arena& arena) {
  if (argument.kind != ValueKind::kList) return Rounded(argument);
  std::vector<Value> items;
  for (const Value& item : argument.list->items()) items.push_back(MakeFeature(item, arena));
  return arena.MakeList(items);
}

bool IsFeatureOf(const Value& feature, const Value& argument) {
  if (argument.kind != ValueKind::kList) return Equal(feature, Rounded(argument));
  if (feature.kind != ValueKind::kList) return false;
  const auto ours = feature.list->items();
  const auto theirs = argument.list->items();
  return std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(), IsFeatureOf);
}

std::uint64_t HashOfFeature(const Value& argument) {
  if (argument.kind != ValueKind::kList) {
    const Value rounded = Rounded(argument);
    return MixHash(static_cast<std::uint64_t>(rounded.kind),
                   rounded.is_number() ? rounded.bits() : rounded.name);
  }
  auto hash = static_cast<std::uint64_t>(argument.kind);
  for (const Value& item : argument.list->items()) hash = MixHash(hash, HashOfFeature(item));
  return hash;
}

}  // namespace latchwork::icarus

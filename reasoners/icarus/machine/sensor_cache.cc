// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/sensor_cache.h"

#include <algorithm>

namespace latchwork::icarus {

namespace {

std::uint64_t HashOf(std::uint32_t function, std::span<const Value> arguments) {
  std::uint64_t hash = function + 1;
  for (const Value& value : arguments) {
    hash = (hash ^ Hash(value)) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 31U;
  }
  return hash;
}

bool IsOf(const SensorCache::Call& call, std::uint32_t function, std::span<const Value> arguments) {
  return call.function == function && std::equal(arguments.begin(), arguments.end(), call.arguments,
                                                 call.arguments + call.count, Equal);
}

}  // namespace

SensorCache::Call& SensorCache::Find(std::size_t place, std::uint32_t function,
                                     std::span<const Value> arguments) {
  if (place >= places_.size()) places_.resize(place + 1, kNoCall);
  places_[place] = Search(function, arguments);
  return calls_[places_[place]];
}

/// The number of the call, which is new when it was not known.
std::uint32_t SensorCache::Search(std::uint32_t function, std::span<const Value> arguments) {
  const std::uint64_t hash = HashOf(function, arguments);
  if (2 * calls_.size() >= table_.size()) Grow();
  const std::size_t mask = table_.size() - 1;
  std::size_t at = hash & mask;
  for (; table_[at] != kNoCall; at = (at + 1) & mask) {
    const Call& call = calls_[table_[at]];
    if (call.hash == hash && IsOf(call, function, arguments)) return table_[at];
  }
  const std::span<Value> copy = arguments_.MakeValues(arguments.size());
  for (std::size_t i = 0; i < copy.size(); ++i) copy[i] = arguments_.Copy(arguments[i]);
  table_[at] = static_cast<std::uint32_t>(calls_.size());
  Call& made = calls_.emplace_back();
  made.arguments = copy.data();
  made.count = static_cast<std::uint32_t>(copy.size());
  made.function = function;
  made.hash = hash;
  return table_[at];
}

void SensorCache::Grow() {
  table_.assign(2 * table_.size(), kNoCall);
  const std::size_t mask = table_.size() - 1;
  for (std::uint32_t i = 0; i < calls_.size(); ++i) {
    std::size_t at = calls_[i].hash & mask;
    while (table_[at] != kNoCall) at = (at + 1) & mask;
    table_[at] = i;
  }
}

void SensorCache::ForgetCalls() {
  calls_.clear();
  std::fill(table_.begin(), table_.end(), kNoCall);
  std::fill(places_.begin(), places_.end(), kNoCall);
  arguments_.Reset();
}

}  // namespace latchwork::icarus

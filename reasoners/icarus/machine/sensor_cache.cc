// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/sensor_cache.h"

#include <algorithm>
#include <new>

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
  places_[place] = Search(function, arguments);
  return *places_[place];
}

/// The call, which is new when it was not known.
SensorCache::Call* SensorCache::Search(std::uint32_t function, std::span<const Value> arguments) {
  const std::uint64_t hash = HashOf(function, arguments);
  if (2 * calls_ >= table_.size()) Grow();
  const std::size_t mask = table_.size() - 1;
  std::size_t at = hash & mask;
  for (; table_[at] != nullptr; at = (at + 1) & mask) {
    Call* const call = table_[at];
    if (call->hash == hash && IsOf(*call, function, arguments)) return call;
  }
  const std::span<Value> copy = arena_.MakeValues(arguments.size());
  for (std::size_t i = 0; i < copy.size(); ++i) copy[i] = arena_.Copy(arguments[i]);
  Call* const made = ::new (arena_.Allocate(sizeof(Call))) Call;
  made->arguments = copy.data();
  made->count = static_cast<std::uint32_t>(copy.size());
  made->function = function;
  made->hash = hash;
  table_[at] = made;
  ++calls_;
  return made;
}

void SensorCache::Grow() {
  std::vector<Call*> larger(2 * table_.size(), nullptr);
  const std::size_t mask = larger.size() - 1;
  for (Call* const call : table_) {
    if (call == nullptr) continue;
    std::size_t at = call->hash & mask;
    while (larger[at] != nullptr) at = (at + 1) & mask;
    larger[at] = call;
  }
  table_.swap(larger);
}

void SensorCache::ForgetCalls() {
  std::fill(table_.begin(), table_.end(), nullptr);
  std::fill(places_.begin(), places_.end(), nullptr);
  calls_ = 0;
  arena_.Reset();
}

}  // namespace latchwork::icarus

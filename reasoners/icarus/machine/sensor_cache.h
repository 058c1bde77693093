// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_SENSOR_CACHE_H_
#define LATCHWORK_ICARUS_SENSOR_CACHE_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

/// The answers of host functions in one cycle, so that one cycle sees one world. Calls are kept
/// from cycle to cycle, so that each place of a program finds its own again without a search;
/// answers are not.
class SensorCache {
 public:
  SensorCache() : table_(64, nullptr) {}

  /// Begins a cycle of a program with so many places: forgets all answers, and the calls, too, when
  /// most are of earlier cycles.
  void Begin(std::size_t places) {
    if (calls_ > 2 * answered_ + kSpareCalls) ForgetCalls();
    if (places > places_.size()) places_.resize(places, nullptr);
    ++cycle_;
    answered_ = 0;
  }

  /// Good until the next Begin.
  struct Call {
    std::uint64_t cycle = 0;  ///< In which it was answered.
    Value answer;
    const Value* arguments = nullptr;
    std::uint32_t count = 0;
    std::uint32_t function = 0;
    std::uint64_t hash = 0;

    std::span<const Value> values() const { return {arguments, count}; }
  };

  /// The call that was asked at this place last; null: none is known.
  Call* Last(std::size_t place) { return places_[place]; }
  Call& Find(std::size_t place, std::uint32_t function, std::span<const Value> arguments);

  bool IsAnswered(const Call& call) const { return call.cycle == cycle_; }

  void Keep(Call& call, const Value& answer) {
    call.cycle = cycle_;
    call.answer = answer;
    ++answered_;
  }

 private:
  static constexpr std::size_t kSpareCalls = 64;

  Call* Search(std::uint32_t function, std::span<const Value> arguments);
  void Grow();
  void ForgetCalls();

  std::vector<Call*> table_;   ///< Calls by hash; a power of two.
  std::vector<Call*> places_;  ///< The last call of each place.
  std::size_t calls_ = 0;
  Arena arena_;  ///< Of the calls and their arguments.
  std::uint64_t cycle_ = 0;
  std::size_t answered_ = 0;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_SENSOR_CACHE_H_

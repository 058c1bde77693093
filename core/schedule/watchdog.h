// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_WATCHDOG_H_
#define LATCHWORK_SCHEDULE_WATCHDOG_H_

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace latchwork::schedule {

/// Cancels what takes longer than `limit`; what ignores that for `grace` more is reported to
/// `on_hang`, once. Thread rule: each guarded place is used by one thread at a time.
class Watchdog {
 public:
  using Clock = std::chrono::steady_clock;
  using OnHang = std::function<void(std::string_view plugin, std::uint64_t tick)>;

  /// One guarded place for each plugin named.
  Watchdog(std::vector<std::string> plugins, std::chrono::milliseconds limit,
           std::chrono::milliseconds grace, OnHang on_hang);

  /// What the work at a place polls.
  const std::atomic<bool>& cancelled(std::size_t place) const { return places_[place].cancelled; }
  void Begin(std::size_t place, std::uint64_t tick);
  /// Whether the work was cancelled.
  bool End(std::size_t place);

 private:
  struct Place {
    std::string plugin;
    std::atomic<bool> cancelled = false;
    bool active = false;
    bool reported = false;
    std::uint64_t tick = 0;
    Clock::time_point begin;
  };

  void Watch(const std::stop_token& stop);
  void Look(Place& place, Clock::time_point now);

  std::chrono::milliseconds limit_;
  std::chrono::milliseconds grace_;
  OnHang on_hang_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::vector<Place> places_;
  std::jthread thread_;
};

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_WATCHDOG_H_

// SPDX-License-Identifier: BSD-3-Clause
#include "core/schedule/watchdog.h"

#include <algorithm>
#include <utility>

namespace latchwork::schedule {

Watchdog::Watchdog(std::vector<std::string> plugins, std::chrono::milliseconds limit,
                   std::chrono::milliseconds grace, OnHang on_hang)
    : limit_(limit), grace_(grace), on_hang_(std::move(on_hang)), places_(plugins.size()) {
  for (std::size_t i = 0; i < plugins.size(); ++i) places_[i].plugin = std::move(plugins[i]);
  thread_ = std::jthread([this](const std::stop_token& stop) { Watch(stop); });
}

void Watchdog::Begin(std::size_t place, std::uint64_t tick) {
  const std::lock_guard lock(mutex_);
  Place& guarded = places_[place];
  guarded.cancelled = false;
  guarded.reported = false;
  guarded.tick = tick;
  guarded.begin = Clock::now();
  guarded.active = true;
}

bool Watchdog::End(std::size_t place) {
  const std::lock_guard lock(mutex_);
  places_[place].active = false;
  return places_[place].cancelled;
}

void Watchdog::Watch(const std::stop_token& stop) {
  const auto pause = std::clamp<std::chrono::milliseconds>(
      std::min(limit_, grace_) / 4, std::chrono::milliseconds(1), std::chrono::milliseconds(250));
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, stop, pause, [&] { return stop.stop_requested(); })) {
    for (Place& place : places_) Look(place, Clock::now());
  }
}

void Watchdog::Look(Place& place, Clock::time_point now) {
  if (!place.active) return;
  if (now - place.begin >= limit_) place.cancelled = true;
  if (place.reported || now - place.begin < limit_ + grace_) return;
  place.reported = true;
  on_hang_(place.plugin, place.tick);
}

}  // namespace latchwork::schedule

// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/garden/gardener.h"

#include <algorithm>
#include <cmath>

namespace latchwork::garden {

namespace {

constexpr double kFillRate = 8.0 / 60;  // l/s
constexpr double kPourRate = 4.0 / 60;  // l/s
constexpr double kFeedSeconds = 300;
constexpr double kCoverSeconds = 600;
constexpr double kThere = 1e-6;  // m

}  // namespace

double Gardener::WayTo(std::size_t place) const {
  return place == kWell ? 0 : static_cast<double>(place + 1) * options_.bed_distance;
}

std::optional<std::size_t> Gardener::place(std::size_t beds) const {
  if (way_ < kThere) return kWell;
  for (std::size_t bed = 0; bed < beds; ++bed) {
    if (std::abs(WayTo(bed) - way_) < kThere) return bed;
  }
  return std::nullopt;
}

void Gardener::Work(std::optional<Task> task, double seconds, std::vector<Bed>& beds,
                    Barrel& barrel) {
  if (task != task_) spent_ = 0;
  task_ = task;
  if (!task) return;
  if (task->kind == Task::Kind::kWalk) {
    Walk(task->place, seconds);
    return;
  }
  const auto here = place(beds.size());
  if (!here) return;
  if (task->kind == Task::Kind::kFill) {
    if (*here != kWell) return;
    const double drawn = std::min({kFillRate * seconds, barrel.water, options_.tank - water_});
    water_ += drawn;
    barrel.water -= drawn;
  } else if (*here != kWell) {
    Handle(*task, seconds, beds[*here]);
  }
}

void Gardener::Walk(std::size_t place, double seconds) {
  const double left = WayTo(place) - way_;
  const double step = std::clamp(left, -options_.speed * seconds, options_.speed * seconds);
  way_ = std::abs(left - step) < kThere ? WayTo(place) : way_ + step;
  walked_ += std::abs(step);
}

void Gardener::Pour(double seconds, Bed& bed) {
  const double given = std::min(kPourRate * seconds, water_);
  bed.AddWater(given);
  water_ -= given;
  poured_ += given;
}

void Gardener::Handle(const Task& task, double seconds, Bed& bed) {
  if (task.kind == Task::Kind::kPour) {
    Pour(seconds, bed);
    return;
  }
  const bool feeds = task.kind == Task::Kind::kFeed;
  if (feeds && portions_ == 0) return;
  spent_ += seconds;
  if (spent_ + kThere < (feeds ? kFeedSeconds : kCoverSeconds)) return;
  spent_ = 0;
  if (feeds) {
    bed.AddFood(options_.portion);
    --portions_;
  } else {
    bed.SetCovered(task.kind == Task::Kind::kCover);
  }
}

}  // namespace latchwork::garden

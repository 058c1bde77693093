// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/map/free_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace latchwork::planning {

FreeSpace::FreeSpace(const DistanceMap& map, double clearance, std::vector<Disc> discs)
    : map_(&map), clearance_(clearance), discs_(std::move(discs)) {
  labels_.assign(static_cast<std::size_t>(map.width()) * static_cast<std::size_t>(map.height()), 0);
  std::vector<std::int32_t> stack;
  std::int32_t label = 0;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (labels_[static_cast<std::size_t>(y * map.width() + x)] == 0 && MayHold(x, y)) {
        Fill(x, y, ++label, stack);
      }
    }
  }
}

double FreeSpace::Clearance(Point place) const {
  double clearance = map_->Clearance(place);
  for (const Disc& disc : discs_) {
    clearance = std::min(clearance, Distance(place, disc.centre) - disc.radius);
  }
  return clearance;
}

bool FreeSpace::IsFree(Point a, Point b) const {
  const double length = Distance(a, b);
  const double least_step = map_->resolution() / 4.0;
  for (double done = 0.0; done < length;) {
    const double spare = Clearance(Between(a, b, done / length)) - clearance_;
    if (spare < 0.0) return false;
    done += std::max(spare, least_step);
  }
  return IsFree(b);
}

/// With a quarter of a cell to spare for what lies between the steps of IsFree.
bool FreeSpace::MayHold(int x, int y) const {
  const double needed = clearance_ - map_->resolution() / 4.0;
  if (map_->MostClearance(x, y) < needed) return false;
  const Point centre = map_->CentreOf(x, y);
  return std::none_of(discs_.begin(), discs_.end(), [&](const Disc& disc) {
    return Distance(centre, disc.centre) + map_->resolution() < disc.radius + needed;
  });
}

void FreeSpace::Fill(int x, int y, std::int32_t label, std::vector<std::int32_t>& stack) {
  const int width = map_->width();
  const auto visit = [&](int at_x, int at_y) {
    if (!map_->IsInside(at_x, at_y)) return;
    const std::int32_t cell = at_y * width + at_x;
    if (labels_[static_cast<std::size_t>(cell)] != 0 || !MayHold(at_x, at_y)) return;
    labels_[static_cast<std::size_t>(cell)] = label;
    stack.push_back(cell);
  };
  visit(x, y);
  while (!stack.empty()) {
    const std::int32_t cell = stack.back();
    stack.pop_back();
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) visit(cell % width + dx, cell / width + dy);
    }
  }
}

std::int32_t FreeSpace::LabelAt(Point place) const {
  const int x = map_->CellX(place.x);
  const int y = map_->CellY(place.y);
  return map_->IsInside(x, y) ? labels_[static_cast<std::size_t>(y * map_->width() + x)] : 0;
}

bool FreeSpace::MayConnect(Point a, Point b) const {
  return LabelAt(a) != 0 && LabelAt(a) == LabelAt(b);
}

std::optional<Point> FreeSpace::NearestFree(Point place, double within) const {
  if (IsFree(place)) return place;
  const int reach = static_cast<int>(std::ceil(within / map_->resolution()));
  const int x = map_->CellX(place.x);
  const int y = map_->CellY(place.y);
  std::optional<Point> best;
  double least = within;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const Point centre = map_->CentreOf(x + dx, y + dy);
      const double distance = Distance(place, centre);
      if (distance >= least || !map_->IsInside(x + dx, y + dy) || !IsFree(centre)) continue;
      least = distance;
      best = centre;
    }
  }
  return best;
}

}  // namespace latchwork::planning

// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/cleaner/ways.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace latchwork::cleaner {

namespace {

// 7 / 5 is nearly the diagonal of a square.
constexpr int kStraight = 5;
constexpr int kDiagonal = 7;
constexpr int kFarthestStart = 2;
constexpr std::array<Tile, 8> kDirections = {
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

int CostOf(Tile step) { return step.i != 0 && step.j != 0 ? kDiagonal : kStraight; }

/// The tile itself when it is open, else the nearest open ones.
template <typename IsOpen>
std::vector<Tile> OpenNear(Tile from, const IsOpen& is_open) {
  std::vector<Tile> near;
  for (int ring = 0; ring <= kFarthestStart && near.empty(); ++ring) {
    for (int j = from.j - ring; j <= from.j + ring; ++j) {
      for (int i = from.i - ring; i <= from.i + ring; ++i) {
        const bool on_ring = std::max(std::abs(i - from.i), std::abs(j - from.j)) == ring;
        if (on_ring && is_open(Tile{i, j})) near.push_back({i, j});
      }
    }
  }
  return near;
}

}  // namespace

void Ways::Begin(const RememberedFloor& floor) {
  const auto size =
      static_cast<std::size_t>(floor.width()) * static_cast<std::size_t>(floor.height());
  costs_.assign(size, kUnmet);
  parent_.assign(size, 0);
  open_.assign(size, 0);
  queue_.resize(kDiagonal + 1);
  for (auto& tiles : queue_) tiles.clear();
  latest_ = 0;
}

bool Ways::IsOpen(const RememberedFloor& floor, Tile tile) {
  if (floor.At(tile) == Memory::kUnknown) return false;
  char& known = open_[floor.IndexOf(tile)];
  if (known == 0) known = floor.IsOpen(tile) ? 1 : 2;
  return known == 1;
}

void Ways::Offer(const RememberedFloor& floor, Tile tile, int cost, std::size_t parent) {
  int& known = costs_[floor.IndexOf(tile)];
  if (known != kUnmet && known <= cost) return;
  known = cost;
  parent_[floor.IndexOf(tile)] = parent;
  queue_[static_cast<std::size_t>(cost) % queue_.size()].push_back(tile);
  latest_ = std::max(latest_, cost);
}

void Ways::Spread(const RememberedFloor& floor, Tile tile, int cost) {
  for (const Tile step : kDirections) {
    const Tile next{tile.i + step.i, tile.j + step.j};
    if (!IsOpen(floor, next)) continue;
    const bool clear = IsOpen(floor, {next.i, tile.j}) && IsOpen(floor, {tile.i, next.j});
    if (clear) Offer(floor, next, cost + CostOf(step), floor.IndexOf(tile));
  }
}

template <typename Visit>
bool Ways::Flood(const RememberedFloor& floor, const Visit& visit) {
  for (int cost = 0; cost <= latest_; ++cost) {
    auto& tiles = queue_[static_cast<std::size_t>(cost) % queue_.size()];
    for (std::size_t n = 0; n < tiles.size(); ++n) {
      const Tile tile = tiles[n];
      if (costs_[floor.IndexOf(tile)] != cost) continue;
      if (visit(tile, cost)) return true;
      Spread(floor, tile, cost);
    }
    tiles.clear();
  }
  return false;
}

std::optional<Ways::Step> Ways::To(const RememberedFloor& floor, Tile from, Tile to) {
  Begin(floor);
  if (!IsOpen(floor, to)) return std::nullopt;
  const auto starts = OpenNear(from, [&](Tile tile) { return IsOpen(floor, tile); });
  Offer(floor, to, 0, floor.IndexOf(to));
  std::optional<Step> step;
  Flood(floor, [&](Tile tile, int cost) {
    if (std::find(starts.begin(), starts.end(), tile) == starts.end()) return false;
    step = tile == from ? Straight(floor, from) : Step{tile, 0};
    step->length = static_cast<double>(cost) / kStraight;
    return true;
  });
  return step;
}

/// Along the parents, which lead to the goal, as far as they go in one direction.
Ways::Step Ways::Straight(const RememberedFloor& floor, Tile from) const {
  const auto next_of = [&](Tile tile) {
    const auto parent = static_cast<int>(parent_[floor.IndexOf(tile)]);
    return Tile{parent % floor.width(), parent / floor.width()};
  };
  Tile end = next_of(from);
  const Tile step{end.i - from.i, end.j - from.j};
  if (step == Tile{0, 0}) return {from, 0};
  for (Tile next = next_of(end); next == Tile{end.i + step.i, end.j + step.j};
       next = next_of(end)) {
    end = next;
  }
  return {end, 0};
}

std::optional<Ways::Step> Ways::ToDirt(const RememberedFloor& floor, Tile from) {
  Begin(floor);
  for (const Tile start : OpenNear(from, [&](Tile tile) { return IsOpen(floor, tile); })) {
    Offer(floor, start, 0, floor.IndexOf(start));
  }
  std::optional<Step> step;
  Flood(floor, [&](Tile tile, int cost) {
    if (!floor.HasDirtAround(tile) || floor.WasTried(tile)) return false;
    step = Step{tile, static_cast<double>(cost) / kStraight};
    return true;
  });
  return step;
}

}  // namespace latchwork::cleaner

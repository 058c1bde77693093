// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/trajectory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "latchwork/logic/atom.h"

namespace latchwork::app {
namespace {

constexpr double kStep = 0.1;        // m; nearer places are passed over
constexpr double kTolerance = 0.04;  // m, from the line that is kept

std::string Number(double metres) {
  const double rounded = std::round(metres * 100) / 100;
  return fmt::format("{}", rounded == 0 ? 0.0 : rounded);
}

}  // namespace

void Trajectory::Add(std::span<const sdk::Batch> sensors) {
  std::optional<Place> place;
  std::int64_t floor = stays_.empty() ? 0 : stays_.back().floor;
  for (const sdk::Batch& batch : sensors) {
    if (!batch.updated) continue;
    for (const logic::Fact& fact : batch.facts) {
      const std::string_view name = fact.predicate().name();
      if (name == "curr_location" && fact.arity() == 2 && fact.argument(0).is_number() &&
          fact.argument(1).is_number()) {
        place = {fact.argument(0).number(), fact.argument(1).number()};
      } else if (name == "curr_floor" && fact.arity() == 1 &&
                 fact.argument(0).kind() == logic::Term::Kind::kInteger) {
        floor = fact.argument(0).integer();
      }
    }
  }
  if (place) Keep(floor, *place);
}

void Trajectory::Keep(std::int64_t floor, const Place& place) {
  if (!std::isfinite(place.x) || !std::isfinite(place.y)) return;
  last_ = place;
  if (stays_.empty() || stays_.back().floor != floor) {
    stays_.push_back({floor, {place}});
    return;
  }
  std::vector<Place>& places = stays_.back().places;
  if (std::hypot(place.x - places.back().x, place.y - places.back().y) >= kStep) {
    places.push_back(place);
  }
}

/// Ramer 1972, Douglas and Peucker 1973; without recursion, since ways may be long.
std::vector<Trajectory::Place> Trajectory::Thinned(const std::vector<Place>& places) {
  std::vector<char> kept(places.size(), 0);
  kept.front() = kept.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, places.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const Place a = places[first];
    const double dx = places[last].x - a.x;
    const double dy = places[last].y - a.y;
    const double squared = dx * dx + dy * dy;
    double farthest = kTolerance;
    std::size_t middle = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double px = places[i].x - a.x;
      const double py = places[i].y - a.y;
      const double along = squared > 0 ? std::clamp((px * dx + py * dy) / squared, 0.0, 1.0) : 0.0;
      const double distance = std::hypot(px - along * dx, py - along * dy);
      if (distance > farthest) std::tie(farthest, middle) = std::pair(distance, i);
    }
    if (middle == first) continue;
    kept[middle] = 1;
    open.insert(open.end(), {{first, middle}, {middle, last}});
  }
  std::vector<Place> thinned;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (kept[i] != 0) thinned.push_back(places[i]);
  }
  return thinned;
}

std::string Trajectory::ToText() const {
  std::string text;
  for (const Stay& stay : stays_) {
    std::vector<Place> places = stay.places;
    if (&stay == &stays_.back()) places.push_back(last_);
    text += fmt::format("{}{}", text.empty() ? "" : ";", stay.floor);
    for (const Place& place : Thinned(places)) {
      text += fmt::format(" {},{}", Number(place.x), Number(place.y));
    }
  }
  return text;
}

}  // namespace latchwork::app

// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/report/trajectory.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>
#include <utility>

namespace latchwork::compare {
namespace {

constexpr double kFarthest = 1e6;  // m

template <typename Number>
bool Take(std::string_view& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc();
}

bool Take(std::string_view& text, char expected) {
  if (!text.starts_with(expected)) return false;
  text.remove_prefix(1);
  return true;
}

/// Of what is farther from the origin, or no number, no drawing can be made.
bool Take(std::string_view& text, double& coordinate) {
  return Take<double>(text, coordinate) && std::abs(coordinate) <= kFarthest;
}

}  // namespace

std::vector<Stay> ReadTrajectory(std::string_view text) {
  std::vector<Stay> stays;
  while (!text.empty()) {
    Stay stay;
    if (!Take(text, stay.floor)) return stays;
    while (Take(text, ' ')) {
      Stay::Place place;
      if (!Take(text, place.x) || !Take(text, ',') || !Take(text, place.y)) return stays;
      stay.places.push_back(place);
    }
    stays.push_back(std::move(stay));
    if (!Take(text, ';')) return stays;
  }
  return stays;
}

}  // namespace latchwork::compare

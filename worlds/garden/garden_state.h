// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_GARDEN_GARDEN_STATE_H_
#define LATCHWORK_GARDEN_GARDEN_STATE_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/garden/bed.h"
#include "worlds/garden/gardener.h"
#include "worlds/garden/weather.h"

namespace latchwork::garden {

/// How things stood at some moment, for the drawings.
struct Moment {
  double hour = 0;
  double way = 0;  ///< Of the gardener, m.
  Sky sky = Sky::kSun;
  double temperature = 0;
  struct OfBed {
    double moisture = 0;
    double food = 0;
    bool covered = false;
    std::vector<double> weights;  ///< Negative when dead.
  };
  std::vector<OfBed> beds;
};

/// What a run changes.
struct GardenState {
  GardenState(std::uint64_t seed, int days, int bed_count, int plants,
              const GardenerOptions& options, int portions);

  /// One step of the season with the gardener at a task.
  void Step(std::optional<Task> task, double seconds);
  bool IsWorkingTime() const;
  int day() const { return static_cast<int>(hour / 24); }
  double clock() const { return hour - 24.0 * day(); }  ///< h
  Air AirNow() const;
  double Weight() const;  ///< kg, of all that live
  int Alive() const;
  int Plants() const;
  double LeastHealth() const;
  std::optional<std::size_t> PlaceOf(std::string_view name) const;
  std::string NameOf(std::size_t place) const;

  Weather weather;
  std::vector<Bed> beds;
  Gardener gardener;
  Barrel barrel;
  double hour = 0;  ///< Since the midnight before the first day.
  std::vector<Moment> moments;

 private:
  void Remember();

  double seconds_ = 0;  ///< Whole numbers of them add up exactly.
};

}  // namespace latchwork::garden

#endif  // LATCHWORK_GARDEN_GARDEN_STATE_H_

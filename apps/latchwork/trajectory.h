// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_TRAJECTORY_H_
#define LATCHWORK_APPS_LATCHWORK_TRAJECTORY_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "latchwork/sdk/world.h"

namespace latchwork::app {

/// Where a robot was, thinned: no place of the way is farther than some centimetres from the line
/// that is kept. It listens to sensor facts curr_location(X, Y) and, where there are floors,
/// curr_floor(K); of a world that says none of them nothing is kept.
class Trajectory {
 public:
  /// The batches of one tick; those that are not new are passed over.
  void Add(std::span<const sdk::Batch> sensors);

  /// "1 2.5,3 4.25,3;2 9,9": for each stay on a floor its number and the places there, m. Empty
  /// when nothing was heard.
  std::string ToText() const;

 private:
  struct Place {
    double x = 0;
    double y = 0;
  };
  struct Stay {
    std::int64_t floor = 0;
    std::vector<Place> places;
  };

  static std::vector<Place> Thinned(const std::vector<Place>& places);
  void Keep(std::int64_t floor, const Place& place);

  std::vector<Stay> stays_;
  Place last_;
};

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_TRAJECTORY_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_REPORT_TRAJECTORY_H_
#define LATCHWORK_APPS_COMPARE_REPORT_TRAJECTORY_H_

#include <cstdint>
#include <string_view>
#include <vector>

namespace latchwork::compare {

/// A part of a way that is on one floor; places in m.
struct Stay {
  struct Place {
    double x = 0;
    double y = 0;
    friend bool operator==(const Place&, const Place&) = default;
  };
  std::int64_t floor = 0;
  std::vector<Place> places;
  friend bool operator==(const Stay&, const Stay&) = default;
};

/// Of the text that a run's record holds: "1 2.5,3 4.25,3;2 9,9". What is not of this shape, and
/// all behind it, is left out.
std::vector<Stay> ReadTrajectory(std::string_view text);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_REPORT_TRAJECTORY_H_

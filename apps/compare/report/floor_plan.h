// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_REPORT_FLOOR_PLAN_H_
#define LATCHWORK_APPS_COMPARE_REPORT_FLOOR_PLAN_H_

#include <atomic>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "apps/compare/experiment/experiment.h"
#include "apps/compare/runs/launch.h"

namespace latchwork::compare {

/// A floor as its world draws it, and where its coordinates lie in the drawing.
struct FloorPlan {
  std::string shapes;  ///< What stands within <svg>.
  double width = 0;    ///< Of the drawing, pixels.
  double height = 0;
  double left = 0;  ///< World coordinate at the left edge, m.
  double top = 0;
  double pixels = 1;  ///< A metre.
};

/// Plans by the numbers of the floors.
using Building = std::map<std::int64_t, FloorPlan>;

/// From a drawing of sdk::Svg; nothing when it is none.
std::optional<FloorPlan> ReadPlan(std::string_view svg);

/// Lets the world of every scenario draw itself ("plan1.svg" for floor 1), in a process of its own
/// that runs for one tick. A world that draws no plans has an empty building, one
/// that cannot run, takes longer than 30 s, or is cut off by `stop`, none. By scenario.
std::map<std::string, Building> DrawBuildings(const Experiment& experiment, const Launch& launch,
                                              const std::atomic<bool>& stop);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_REPORT_FLOOR_PLAN_H_

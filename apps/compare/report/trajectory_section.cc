// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "apps/compare/report/html.h"
#include "apps/compare/report/trajectory.h"

namespace latchwork::compare {
namespace {

constexpr double kFloorGap = 40;  // pixels of a plan, above it for the name of the floor

/// The floors of a scenario that any run was on, one above the other.
struct Layout {
  struct Floor {
    const FloorPlan* plan = nullptr;
    double top = 0;
  };
  std::map<std::int64_t, Floor> floors;
  double width = 0;
  double height = 0;
};

Layout Arrange(const ReportInput& input, const std::string& scenario, const Building& building) {
  std::set<std::int64_t> visited;
  for (const Contender& contender : input.experiment.contenders) {
    for (const RunRecord* run : RunsOf(input, scenario, contender.name)) {
      for (const Stay& stay : ReadTrajectory(run->trajectory)) visited.insert(stay.floor);
    }
  }
  Layout layout;
  for (auto floor = visited.rbegin(); floor != visited.rend(); ++floor) {
    const auto plan = building.find(*floor);
    if (plan == building.end()) continue;
    layout.floors[*floor] = {&plan->second, layout.height + kFloorGap};
    layout.height += kFloorGap + plan->second.height;
    layout.width = std::max(layout.width, plan->second.width);
  }
  return layout;
}

/// In whole pixels of the plan, each place relative to the one before, so that reports of many runs
/// stay small; `end` is where the run ended.
std::string Way(const RunRecord& run, const Layout& layout, std::string& end) {
  std::string way;
  for (const Stay& stay : ReadTrajectory(run.trajectory)) {
    const auto floor = layout.floors.find(stay.floor);
    if (floor == layout.floors.end() || stay.places.empty()) continue;
    const FloorPlan& plan = *floor->second.plan;
    std::int64_t last_x = 0;
    std::int64_t last_y = 0;
    for (std::size_t i = 0; i < stay.places.size(); ++i) {
      const std::int64_t x = std::llround((stay.places[i].x - plan.left) * plan.pixels);
      const std::int64_t y =
          std::llround((plan.top - stay.places[i].y) * plan.pixels + floor->second.top);
      way +=
          i == 0 ? fmt::format("M{},{}l0,0", x, y) : fmt::format(" {},{}", x - last_x, y - last_y);
      last_x = x;
      last_y = y;
    }
    end = fmt::format("M{},{}l20,20m0,-20l-20,20", last_x - 10, last_y - 10);
  }
  return way;
}

/// The plans of all scenarios, each drawing once however many scenarios share it.
class Plans {
 public:
  explicit Plans(const ReportInput& input) {
    for (const Scenario& scenario : input.experiment.scenarios) {
      const auto building = input.buildings.find(scenario.name);
      if (building == input.buildings.end()) continue;
      for (const auto& [number, plan] : building->second) {
        names_.emplace(plan.shapes, fmt::format("plan{}", names_.size()));
      }
    }
  }

  std::string Symbols() const {
    std::string symbols = "<svg class=\"defs\" aria-hidden=\"true\">\n";
    for (const auto& [shapes, name] : names_) {
      symbols +=
          fmt::format("<symbol id=\"{}\" overflow=\"visible\">\n{}</symbol>\n", name, shapes);
    }
    return symbols + "</svg>\n";
  }
  const std::string& NameOf(const FloorPlan& plan) const { return names_.at(plan.shapes); }

 private:
  std::map<std::string, std::string> names_;
};

std::string Figure(const ReportInput& input, const Layout& layout, const Plans& plans,
                   const std::string& scenario, const std::string& contender) {
  const std::string agent_class = AgentClass(input.experiment, contender);
  std::string ways;
  std::string ends;
  std::size_t reached = 0;
  const std::vector<const RunRecord*> runs = RunsOf(input, scenario, contender);
  for (const RunRecord* run : runs) {
    std::string end;
    const std::string way = Way(*run, layout, end);
    if (!way.empty()) ways += fmt::format("<path class=\"way {}\" d=\"{}\"/>\n", agent_class, way);
    if (run->outcome == Outcome::kReached) {
      ++reached;
    } else {
      ends += end;
    }
  }
  const std::string count =
      runs.empty() ? "no runs yet" : fmt::format("{} of {} reached", reached, runs.size());
  std::string figure = fmt::format(
      "<figure>\n<figcaption>{}{} <small>{}</small></figcaption>\n"
      "<svg class=\"chart ways\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\">"
      "<title>Ways of {} in {}</title><desc>The ways of {} runs over {} floors; a cross marks "
      "where "
      "a run that did not reach the goal ended.</desc>\n",
      Key(input.experiment, contender), Escaped(contender), count, layout.width, layout.height,
      Escaped(contender), Escaped(scenario), runs.size(), layout.floors.size());
  for (const auto& [number, floor] : layout.floors) {
    figure += fmt::format(
        "<text class=\"floor\" x=\"2\" y=\"{:.0f}\">floor {}</text>"
        "<use class=\"plan\" href=\"#{}\" y=\"{:.0f}\"/>\n",
        floor.top - 12, number, plans.NameOf(*floor.plan), floor.top);
  }
  figure += ways;
  if (!ends.empty()) figure += fmt::format("<path class=\"way end\" d=\"{}\"/>\n", ends);
  return figure + "</svg>\n</figure>\n";
}

}  // namespace

std::string TrajectorySection(const ReportInput& input) {
  const Plans plans(input);
  std::string figures;
  for (const Scenario& scenario : input.experiment.scenarios) {
    const auto building = input.buildings.find(scenario.name);
    if (building == input.buildings.end()) {
      figures += fmt::format(
          "<p class=\"note\">The floors of {} could not be drawn: the world did not run for the "
          "report.</p>\n",
          Escaped(scenario.name));
      continue;
    }
    const Layout layout = Arrange(input, scenario.name, building->second);
    if (layout.floors.empty()) continue;
    figures += fmt::format("<h3>{}</h3>\n<div class=\"charts\">\n", Escaped(scenario.name));
    for (const Contender& contender : input.experiment.contenders) {
      figures += Figure(input, layout, plans, scenario.name, contender.name);
    }
    figures += "</div>\n";
  }
  if (figures.empty()) return "";
  return "<section id=\"trajectories\">\n<h2>Trajectories</h2>\n<p>The ways of all runs, on the "
         "floors that any of them was on; the rings mark the goal, a cross where a run that did "
         "not reach it ended.</p>\n" +
         plans.Symbols() + figures + "</section>\n";
}

}  // namespace latchwork::compare

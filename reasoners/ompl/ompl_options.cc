// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/ompl_options.h"

#include <string>
#include <vector>

#include "latchwork/sdk/specs.h"
#include "reasoners/ompl/paths/planner_table.h"

namespace latchwork::planning {
namespace {

using sdk::BooleanParameter;
using sdk::ChoiceParameter;
using sdk::IntegerParameter;
using sdk::ParameterSpec;
using sdk::ParameterType;
using sdk::RealParameter;

std::vector<ParameterSpec> MakeOptions() {
  return {
      {.name = "map",
       .type = ParameterType::kFile,
       .help = "what the robot moves in: a building (.p), or one floor (.png)",
       .choices = {}},
      RealParameter("resolution", "0.05", 0.005, 1.0, "m", "of a pixel, for a .png map"),
      ChoiceParameter("planner", PlannerNames(), "of OMPL"),
      {.name = "options",
       .type = ParameterType::kText,
       .default_value = "",
       .help = "the planner's own, such as 'range=2 goal_bias=0.1'",
       .choices = {}},
      ChoiceParameter("space", {"r2", "se2", "reeds_shepp"}, "what is planned in"),
      RealParameter("turning_radius", "0.5", 0.05, 10.0, "m", "of a Reeds-Shepp car"),
      RealParameter("clearance", "0.3", 0.05, 5.0, "m",
                    "that the robot's centre keeps from everything in the map"),
      BooleanParameter("simplify", true, "shorten and smooth what the planner found"),
      BooleanParameter("optimize", false,
                       "an optimizing planner goes on until the effort is spent"),
      IntegerParameter("effort", "100000", 10, 1e9,
                       "checks and rounds for one path; never more than the layer's inferences"),
      IntegerParameter("tries", "3", 1, 100, "the shortest path of so many counts"),
      IntegerParameter("seed", "1", 0, 4e9, "of all planners"),
      RealParameter("lookahead", "1", 0.1, 10.0, "m", "seek: the point of the path to go for"),
      RealParameter("stray", "0.7", 0.05, 10.0, "m", "seek: farther from its path it plans anew"),
      RealParameter("ride_cost", "20", 0.0, 1000.0, "m", "itinerary: what a ride is worth on foot"),
  };
}

SpaceKind KindOf(const std::string& name) {
  if (name == "se2") return SpaceKind::kPlaneAndHeading;
  return name == "reeds_shepp" ? SpaceKind::kReedsShepp : SpaceKind::kPlane;
}

}  // namespace

std::span<const ParameterSpec> OmplOptions() {
  static const std::vector<ParameterSpec> options = MakeOptions();
  return options;
}

JobSetup SetupFrom(const sdk::Parameters& values, logic::Diagnostics& diagnostics) {
  JobSetup setup;
  PathSettings& paths = setup.paths;
  paths.planner = values.Text("planner");
  paths.options = ReadPlannerOptions(values.Text("options"), paths.planner,
                                     values.PlaceOf("options"), diagnostics);
  paths.space = KindOf(values.Text("space"));
  paths.turning_radius = values.Real("turning_radius");
  paths.effort = static_cast<std::uint64_t>(values.Integer("effort"));
  paths.seed = static_cast<std::uint64_t>(values.Integer("seed"));
  paths.tries = static_cast<int>(values.Integer("tries"));
  paths.simplify = values.Boolean("simplify");
  paths.optimize = values.Boolean("optimize");
  setup.clearance = values.Real("clearance");
  setup.lookahead = values.Real("lookahead");
  setup.stray = values.Real("stray");
  setup.ride_cost = values.Real("ride_cost");
  return setup;
}

}  // namespace latchwork::planning

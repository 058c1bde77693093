// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <utility>

#include "latchwork/sdk/specs.h"
#include "worlds/office/office_contract.h"

namespace latchwork::office {

namespace {

using sdk::ChoiceParameter;
using sdk::IntegerParameter;
using sdk::ParameterSpec;
using sdk::ParameterType;
using sdk::RealParameter;

ParameterSpec Other(std::string name, ParameterType type, std::string value, std::string help) {
  ParameterSpec spec;
  spec.name = std::move(name);
  spec.type = type;
  spec.default_value = std::move(value);
  spec.help = std::move(help);
  return spec;
}

}  // namespace

std::vector<ParameterSpec> OfficeParameters() {
  return {
      Other("building", ParameterType::kFile, "", "a building (.p); empty: the shipped one"),
      Other("map", ParameterType::kFile, "",
            "instead of a building: one floor (.png .pgm .yaml .gridmap[.gz] .simplemap[.gz])"),
      RealParameter("resolution", "0.05", 0.005, 1.0, "m", "of a pixel, for .png and .pgm maps"),
      Other("start", ParameterType::kText, "",
            "a landmark; 'pose' for start_floor, start_x, start_y; empty: anywhere, by seed"),
      IntegerParameter("start_floor", "0", 0, 1000, "of a pose, or of a start by seed; 0: any"),
      RealParameter("start_x", "0", -1e6, 1e6, "m", "of a pose"),
      RealParameter("start_y", "0", -1e6, 1e6, "m", "of a pose"),
      RealParameter("start_spread", "0", 0.0, 5.0, "m",
                    "by seed up to this far from the start landmark"),
      Other("start_heading", ParameterType::kText, "", "rad; empty: by seed"),
      Other("goal", ParameterType::kText, "", "a landmark to reach; empty: none, it wanders"),
      ChoiceParameter(
          "destinations", {"none", "random"},
          "places that the world names one after the other, by seed, for layers 0 and 1 alone"),
      RealParameter("drive_for", "0", 0.0, 1e6, "s",
                    "after this time without a collision the run has reached its end; 0: off"),
      Other("end_at_collision", ParameterType::kBoolean, "true", "whether a collision is the end"),
      RealParameter("max_speed", "0.6", 0.05, 2.0, "m/s", "of the robot"),
      IntegerParameter("sonars", "16", 1, 360, "in the ring"),
      RealParameter("sonar_cone", "25", 0.0, 90.0, "deg", "full opening angle"),
      IntegerParameter("sonar_rays", "11", 1, 181, "cast in a cone"),
      RealParameter("sonar_range", "5", 0.2, 50.0, "m", "farthest echo"),
      RealParameter("sonar_min_range", "0.05", 0.0, 1.0, "m", "nearer echoes read as this"),
      RealParameter("sonar_noise", "0.01", 0.0, 1.0, "m", "standard deviation of a reading"),
      RealParameter("sonar_missed", "0.005", 0.0, 1.0, "", "probability that an echo is not heard"),
      RealParameter("odometry_noise", "0", 0.0, 1.0, "m", "deviation of the pose after one metre"),
      IntegerParameter("boxes", "0", 0, 1000, "left standing around, by seed"),
      Other("box", ParameterType::kText, "", "boxes: 'floor x y width depth; ...', m"),
      IntegerParameter("people", "0", 0, 200, "walking in the corridors, by seed"),
      Other("shut", ParameterType::kText, "", "names of doors that are shut, with blanks"),
      IntegerParameter("shut_doors", "0", 0, 1000,
                       "further doors shut by seed; start and goal stay linked"),
      RealParameter("elevator_calls", "30", 0.0, 3600.0, "1/h",
                    "of other people, for each elevator"),
      RealParameter("elevator_door_time", "2", 0.1, 60.0, "s", "to open or to close"),
      RealParameter("elevator_dwell_time", "6", 0.1, 600.0, "s",
                    "open without anybody in the door"),
      RealParameter("elevator_floor_time", "5", 0.1, 600.0, "s", "from floor to floor"),
      Other("elevator_floors", ParameterType::kText, "",
            "floors at which the cabs start, with blanks; empty: by seed"),
  };
}

}  // namespace latchwork::office

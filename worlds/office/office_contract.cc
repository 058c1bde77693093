// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/office_contract.h"

#include <string>
#include <utility>

namespace latchwork::office {

namespace {

using sdk::ArgumentSpec;
using sdk::ArgumentType;
using sdk::ParameterSpec;
using sdk::ParameterType;
using sdk::PredicateSpec;

ArgumentSpec Integer(std::string name) { return {std::move(name), ArgumentType::kInteger, {}}; }
ArgumentSpec Real(std::string name, std::string unit) {
  return {std::move(name), ArgumentType::kReal, std::move(unit)};
}
ArgumentSpec Word(std::string name) { return {std::move(name), ArgumentType::kSymbol, {}}; }

ParameterSpec Number(std::string name, std::string value, double low, double high, std::string unit,
                     std::string help) {
  return {std::move(name),
          ParameterType::kReal,
          std::move(value),
          low,
          high,
          std::move(unit),
          std::move(help),
          {}};
}

ParameterSpec Count(std::string name, std::string value, double low, double high,
                    std::string help) {
  return {std::move(name),
          ParameterType::kInteger,
          std::move(value),
          low,
          high,
          {},
          std::move(help),
          {}};
}

ParameterSpec Other(std::string name, ParameterType type, std::string value, std::string help) {
  ParameterSpec spec;
  spec.name = std::move(name);
  spec.type = type;
  spec.default_value = std::move(value);
  spec.help = std::move(help);
  return spec;
}

std::vector<sdk::PortSpec> Effectors() {
  return {
      {"drive",
       {{"fwd", {Real("speed", "m/s")}, "drive on at this speed, 0 to max_speed"},
        {"turn", {Real("angle", "rad")}, "turn by this angle from the present heading, left > 0"},
        {"halt", {}, "brake to a stand whatever fwd says; turning stays possible"}},
       "what the base is told; nothing: it rolls out",
       true,
       false},
      {"buttons",
       {{"call", {Word("elevator"), Integer("floor")}, "call an elevator to a floor"},
        {"ride", {Word("elevator"), Integer("floor")}, "in the cab: go to a floor"}},
       "elevator calls",
       true,
       false},
  };
}

std::vector<sdk::PortSpec> Sensors() {
  return {
      {"sonar",
       {{"sonar_reading", {Integer("sonar"), Real("distance", "m")}, "an echo, from the rim"},
        {"no_echo", {Integer("sonar")}, "nothing was heard within the range"}},
       "0 points ahead, numbers run counter-clockwise"},
      {"pose",
       {{"curr_location", {Real("x", "m"), Real("y", "m")}, "in the frame of the building"},
        {"curr_heading", {Real("heading", "rad")}, "counter-clockwise from east, (-pi, pi]"}},
       "where the robot is and looks"},
      {"place",
       {{"curr_landmark", {Word("landmark")}, "the last landmark that was reached"},
        {"curr_floor", {Integer("floor")}, "the floor; in a cab the cab's"}},
       "the same in names"},
      {"elevators",
       {{"elevator_at", {Word("elevator"), Integer("floor")}, "where the cab is or was last"},
        {"elevator_door", {Word("elevator"), Word("state")}, "open, opening, closing or closed"},
        {"elevator_moving", {Word("elevator")}, "the cab is between two floors"},
        {"out_of_order", {Word("elevator")}, "it takes no calls"},
        {"elevator_out_of_order", {Word("elevator")}, "the same"},
        {"elevator_open", {Word("elevator")}, "its door is fully open where it is"},
        {"inside", {Word("elevator")}, "the robot is in its cab"}},
       "what the displays of the elevators show"},
      {"doors",
       {{"door_shut", {Word("door")}, "seen shut from within 2.5 m, and not seen open since"}},
       "doors that the robot knows to be shut"},
      {"goal", {{"goal", {Word("landmark")}, "where it shall go"}}, "the task of the run"},
      {"robot",
       {{"sonar_direction", {Integer("sonar"), Real("angle", "rad")}, "where a sonar looks"},
        {"robot_radius", {Real("radius", "m")}, "of the hull"}},
       "what the robot is like; once, at the first tick"},
      {"building",
       {{"landmark",
         {Word("landmark"), Integer("floor"), Real("x", "m"), Real("y", "m")},
         "a named place; floor 0: in a cab"},
        {"adjacent", {Word("landmark"), Word("landmark")}, "a straight free way, both directions"},
        {"elevator", {Word("elevator")}, "an elevator"},
        {"elevator_front",
         {Word("elevator"), Word("landmark"), Integer("floor")},
         "the landmark before its door"},
        {"cab", {Word("elevator"), Word("landmark")}, "the landmark in its cab"}},
       "what does not change; once, at the first tick"},
      {"destination",
       {{"move_cmd", {Real("x", "m"), Real("y", "m")}, "go there"}},
       "places to seek, when `destinations` is on"},
  };
}

}  // namespace

sdk::Contract OfficeContract() { return {Effectors(), Sensors()}; }

std::vector<PredicateSpec> OfficeEvents() {
  return {
      {"door_shut", {Word("door")}, "somebody shuts a door"},
      {"door_opened", {Word("door")}, "somebody opens a door"},
      {"out_of_order", {Word("elevator")}, "an elevator fails"},
      {"in_service", {Word("elevator")}, "an elevator works again"},
      {"box_put",
       {Integer("floor"), Real("x", "m"), Real("y", "m"), Real("size", "m")},
       "a square box is put down, centred at x, y"},
  };
}

std::vector<ParameterSpec> OfficeParameters() {
  return {
      Other("building", ParameterType::kFile, "", "a building (.p); empty: the shipped one"),
      Other("map", ParameterType::kFile, "",
            "instead of a building: one floor (.png .pgm .yaml .gridmap[.gz] .simplemap[.gz])"),
      Number("resolution", "0.05", 0.005, 1.0, "m", "of a pixel, for .png and .pgm maps"),
      Other("start", ParameterType::kText, "",
            "a landmark; 'pose' for start_floor, start_x, start_y; empty: anywhere, by seed"),
      Count("start_floor", "0", 0, 1000, "of a pose, or of a start by seed; 0: any"),
      Number("start_x", "0", -1e6, 1e6, "m", "of a pose"),
      Number("start_y", "0", -1e6, 1e6, "m", "of a pose"),
      Number("start_spread", "0", 0.0, 5.0, "m", "by seed up to this far from the start landmark"),
      Other("start_heading", ParameterType::kText, "", "rad; empty: by seed"),
      Other("goal", ParameterType::kText, "", "a landmark to reach; empty: none, it wanders"),
      Other("destinations", ParameterType::kBoolean, "false",
            "name places in sight to seek, by seed, another when one is reached or after 60 s"),
      Other("end_at_collision", ParameterType::kBoolean, "true", "whether a collision is the end"),
      Number("max_speed", "0.6", 0.05, 2.0, "m/s", "of the robot"),
      Count("sonars", "16", 1, 360, "in the ring"),
      Number("sonar_cone", "25", 0.0, 90.0, "deg", "full opening angle"),
      Count("sonar_rays", "11", 1, 181, "cast in a cone"),
      Number("sonar_range", "5", 0.2, 50.0, "m", "farthest echo"),
      Number("sonar_min_range", "0.05", 0.0, 1.0, "m", "nearer echoes read as this"),
      Number("sonar_noise", "0.01", 0.0, 1.0, "m", "standard deviation of a reading"),
      Number("sonar_missed", "0.005", 0.0, 1.0, "", "probability that an echo is not heard"),
      Number("odometry_noise", "0", 0.0, 1.0, "m", "deviation of the pose after one metre"),
      Count("boxes", "0", 0, 1000, "left standing around, by seed"),
      Other("box", ParameterType::kText, "", "boxes: 'floor x y width depth; ...', m"),
      Count("people", "0", 0, 200, "walking in the corridors, by seed"),
      Other("shut", ParameterType::kText, "", "names of doors that are shut, with blanks"),
      Count("shut_doors", "0", 0, 1000, "further doors shut by seed; start and goal stay linked"),
      Number("elevator_calls", "30", 0.0, 3600.0, "1/h", "of other people, for each elevator"),
      Number("elevator_door_time", "2", 0.1, 60.0, "s", "to open or to close"),
      Number("elevator_dwell_time", "6", 0.1, 600.0, "s", "open without anybody in the door"),
      Number("elevator_floor_time", "5", 0.1, 600.0, "s", "from floor to floor"),
      Other("elevator_floors", ParameterType::kText, "",
            "floors at which the cabs start, with blanks; empty: by seed"),
  };
}

}  // namespace latchwork::office

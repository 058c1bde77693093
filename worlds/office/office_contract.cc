// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/office_contract.h"

#include <string>
#include <utility>

namespace latchwork::office {

namespace {

using sdk::ArgumentSpec;
using sdk::ArgumentType;
using sdk::PortSpec;
using sdk::PredicateSpec;

ArgumentSpec Integer(std::string name) { return {std::move(name), ArgumentType::kInteger, {}}; }
ArgumentSpec Real(std::string name, std::string unit) {
  return {std::move(name), ArgumentType::kReal, std::move(unit)};
}
ArgumentSpec Word(std::string name) { return {std::move(name), ArgumentType::kSymbol, {}}; }

PortSpec DrivePort() {
  return {
      "drive",
      {{"fwd", {Real("speed", "m/s")}, "drive on at this speed, 0 to max_speed"},
       {"turn", {Real("angle", "rad")}, "turn by this angle from the present heading, left > 0"},
       {"halt", {}, "brake to a stand whatever fwd says; turning stays possible"}},
      "what the base is told; nothing: it rolls out",
      true};
}

PortSpec ButtonsPort() {
  return {"buttons",
          {{"call", {Word("elevator"), Integer("floor")}, "the button on a floor"},
           {"ride", {Word("elevator"), Integer("floor")}, "in the cab, the button for a floor"}},
          "what is pressed at the elevators",
          true};
}

PortSpec SonarPort() {
  return {"sonar",
          {{"sonar_reading", {Integer("sonar"), Real("gap", "m")}, "an echo, from the rim"},
           {"no_echo", {Integer("sonar")}, "nothing was heard within the range"}},
          "every tick; 0 looks ahead, numbers run counter-clockwise"};
}

PortSpec RobotPort() {
  return {"robot",
          {{"sonar_direction", {Integer("sonar"), Real("angle", "rad")}, "0 ahead, left > 0"},
           {"robot_radius", {Real("radius", "m")}, "of its rim"}},
          "what the robot is like; at tick 0"};
}

PortSpec PosePort() {
  return {"pose",
          {{"curr_location", {Real("x", "m"), Real("y", "m")}, "in the frame of the building"},
           {"curr_heading", {Real("heading", "rad")}, "counter-clockwise from east, (-pi, pi]"},
           {"curr_floor", {Integer("floor")}, "in a cab the cab's"}},
          "where the robot is and looks; every tick"};
}

PortSpec PlacePort() {
  return {"place",
          {{"curr_landmark", {Word("landmark")}, "the last landmark that was reached"}},
          "the robot's place by name; when it changes"};
}

PortSpec BuildingPort() {
  return {"building",
          {{"landmark",
            {Word("landmark"), Integer("floor"), Real("x", "m"), Real("y", "m")},
            "a named place; floor 0 in a cab"},
           {"adjacent", {Word("from"), Word("to")}, "a straight way, in both directions"},
           {"elevator", {Word("elevator")}, "there is such an elevator"},
           {"elevator_front",
            {Word("elevator"), Word("landmark"), Integer("floor")},
            "the landmark before its door on a floor"},
           {"cab", {Word("elevator"), Word("landmark")}, "the landmark in its cab"}},
          "what does not change; at tick 0"};
}

PortSpec ElevatorsPort() {
  return {"elevators",
          {{"elevator_at", {Word("elevator"), Integer("floor")}, "where the cab is or was last"},
           {"elevator_open", {Word("elevator")}, "its door is fully open at its floor"},
           {"elevator_out_of_order", {Word("elevator")}, "it takes no calls"},
           {"inside", {Word("elevator")}, "the robot is in its cab"}},
          "how the elevators are; when it changes"};
}

PortSpec DoorsPort() {
  return {"doors",
          {{"door_shut", {Word("landmark")}, "the landmark in the middle of a shut door"}},
          "all doors that are shut in the building; when it changes"};
}

PortSpec GoalPort() {
  return {"goal",
          {{"goal", {Word("landmark")}, "where the user wants the robot"}},
          "the task of the run; at tick 0 and when it changes"};
}

PortSpec DestinationPort() {
  return {"destination",
          {{"move_cmd", {Real("x", "m"), Real("y", "m")}, "go there"}},
          "a place by seed, with destinations=random; when it changes"};
}

}  // namespace

sdk::Contract OfficeContract() {
  return {{DrivePort(), ButtonsPort()},
          {SonarPort(), RobotPort(), PosePort(), PlacePort(), BuildingPort(), ElevatorsPort(),
           DoorsPort(), GoalPort(), DestinationPort()}};
}

std::vector<PredicateSpec> OfficeEvents() {
  return {
      {"door_shuts", {Word("landmark")}, "somebody shuts a door, once nobody is in it"},
      {"door_opens", {Word("landmark")}, "somebody opens a door"},
      {"out_of_order", {Word("elevator")}, "an elevator fails"},
      {"in_service", {Word("elevator")}, "an elevator works again"},
      {"box_put",
       {Integer("floor"), Real("x", "m"), Real("y", "m"), Real("size", "m")},
       "a square box is put down, centred at x, y"},
      {"sonar_fails", {Integer("sonar")}, "a sonar hears nothing from now on"},
      {"sonar_recovers", {Integer("sonar")}, "it hears again"},
      {"goal_changes", {Word("landmark")}, "the user wants the robot elsewhere"},
  };
}

}  // namespace latchwork::office

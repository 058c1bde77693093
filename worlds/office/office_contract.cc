// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/office_contract.h"

#include <string>
#include <utility>

#include "latchwork/sdk/specs.h"

namespace latchwork::office {

namespace {

using sdk::IntegerArgument;
using sdk::PortSpec;
using sdk::PredicateSpec;
using sdk::RealArgument;
using sdk::SymbolArgument;

PortSpec DrivePort() {
  return {"drive",
          {{"fwd", {RealArgument("speed", "m/s")}, "drive on at this speed, 0 to max_speed"},
           {"turn",
            {RealArgument("angle", "rad")},
            "turn by this angle from the present heading, left > 0"},
           {"halt", {}, "brake to a stand whatever fwd says; turning stays possible"}},
          "what the base is told; nothing: it rolls out",
          true};
}

PortSpec ButtonsPort() {
  return {
      "buttons",
      {{"call", {SymbolArgument("elevator"), IntegerArgument("floor")}, "the button on a floor"},
       {"ride",
        {SymbolArgument("elevator"), IntegerArgument("floor")},
        "in the cab, the button for a floor"}},
      "what is pressed at the elevators",
      true};
}

PortSpec SonarPort() {
  return {"sonar",
          {{"sonar_reading",
            {IntegerArgument("sonar"), RealArgument("gap", "m")},
            "an echo, from the rim"},
           {"no_echo", {IntegerArgument("sonar")}, "nothing was heard within the range"}},
          "every tick; 0 looks ahead, numbers run counter-clockwise"};
}

PortSpec RobotPort() {
  return {"robot",
          {{"sonar_direction",
            {IntegerArgument("sonar"), RealArgument("angle", "rad")},
            "0 ahead, left > 0"},
           {"robot_radius", {RealArgument("radius", "m")}, "of its rim"}},
          "what the robot is like; at tick 0"};
}

PortSpec PosePort() {
  return {
      "pose",
      {{"curr_location",
        {RealArgument("x", "m"), RealArgument("y", "m")},
        "in the frame of the building"},
       {"curr_heading", {RealArgument("heading", "rad")}, "counter-clockwise from east, (-pi, pi]"},
       {"curr_floor", {IntegerArgument("floor")}, "in a cab the cab's"}},
      "where the robot is and looks; every tick"};
}

PortSpec PlacePort() {
  return {"place",
          {{"curr_landmark", {SymbolArgument("landmark")}, "the last landmark that was reached"}},
          "the robot's place by name; when it changes"};
}

PortSpec BuildingPort() {
  return {"building",
          {{"landmark",
            {SymbolArgument("landmark"), IntegerArgument("floor"), RealArgument("x", "m"),
             RealArgument("y", "m")},
            "a named place; floor 0 in a cab"},
           {"adjacent",
            {SymbolArgument("from"), SymbolArgument("to")},
            "a straight way, in both directions"},
           {"elevator", {SymbolArgument("elevator")}, "there is such an elevator"},
           {"elevator_front",
            {SymbolArgument("elevator"), SymbolArgument("landmark"), IntegerArgument("floor")},
            "the landmark before its door on a floor"},
           {"cab",
            {SymbolArgument("elevator"), SymbolArgument("landmark")},
            "the landmark in its cab"}},
          "what does not change; at tick 0"};
}

PortSpec ElevatorsPort() {
  return {"elevators",
          {{"elevator_at",
            {SymbolArgument("elevator"), IntegerArgument("floor")},
            "where the cab is or was last"},
           {"elevator_open", {SymbolArgument("elevator")}, "its door is fully open at its floor"},
           {"elevator_out_of_order", {SymbolArgument("elevator")}, "it takes no calls"},
           {"inside", {SymbolArgument("elevator")}, "the robot is in its cab"}},
          "how the elevators are; when it changes"};
}

PortSpec DoorsPort() {
  return {
      "doors",
      {{"door_shut", {SymbolArgument("landmark")}, "the landmark in the middle of a shut door"}},
      "all doors that are shut in the building; when it changes"};
}

PortSpec GoalPort() {
  return {"goal",
          {{"goal", {SymbolArgument("landmark")}, "where the user wants the robot"}},
          "the task of the run; at tick 0 and when it changes"};
}

PortSpec DestinationPort() {
  return {"destination",
          {{"move_cmd", {RealArgument("x", "m"), RealArgument("y", "m")}, "go there"}},
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
      {"door_shuts", {SymbolArgument("landmark")}, "somebody shuts a door, once nobody is in it"},
      {"door_opens", {SymbolArgument("landmark")}, "somebody opens a door"},
      {"out_of_order", {SymbolArgument("elevator")}, "an elevator fails"},
      {"in_service", {SymbolArgument("elevator")}, "an elevator works again"},
      {"box_put",
       {IntegerArgument("floor"), RealArgument("x", "m"), RealArgument("y", "m"),
        RealArgument("size", "m")},
       "a square box is put down, centred at x, y"},
      {"sonar_fails", {IntegerArgument("sonar")}, "a sonar hears nothing from now on"},
      {"sonar_recovers", {IntegerArgument("sonar")}, "it hears again"},
      {"goal_changes", {SymbolArgument("landmark")}, "the user wants the robot elsewhere"},
  };
}

}  // namespace latchwork::office

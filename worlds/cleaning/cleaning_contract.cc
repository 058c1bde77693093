// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cleaning/cleaning_contract.h"

#include <string>
#include <utility>

#include "latchwork/sdk/specs.h"

namespace latchwork::cleaning {

namespace {

using sdk::IntegerArgument;
using sdk::ParameterSpec;
using sdk::ParameterType;
using sdk::PortSpec;
using sdk::PredicateSpec;
using sdk::RealArgument;
using sdk::RealParameter;
using sdk::SymbolArgument;

PortSpec DrivePort() {
  return {"drive",
          {{"drive",
            {RealArgument("speed", "m/s"), RealArgument("turn_rate", "rad/s")},
            "backwards < 0, to the left > 0"}},
          "what the wheels are told; nothing: stand",
          true};
}

PortSpec RobotPort() {
  return {
      "robot",
      {{"tile_size", {RealArgument("side", "m")}, "of the tiles that the floor is divided into"},
       {"dock", {IntegerArgument("i"), IntegerArgument("j")}, "the tile of the dock"}},
      "what the robot knows of itself and its home; at tick 0"};
}

PortSpec PosePort() {
  return {"pose",
          {{"pose",
            {RealArgument("x", "m"), RealArgument("y", "m"), RealArgument("heading", "rad")},
            "x to the east, y to the north, heading counter-clockwise from east"}},
          "where the robot takes itself to be; every tick"};
}

PortSpec ViewPort() {
  return {"view",
          {{"picture", {IntegerArgument("number")}, "counts the pictures"},
           {"row_in_view", {IntegerArgument("j")}, "a row with tiles in this picture"},
           {"tile",
            {IntegerArgument("i"), IntegerArgument("j"), SymbolArgument("state")},
            "dirty, clean, or blocked: something stands there"}},
          "the tiles around the robot that it sees; a picture at a time"};
}

PortSpec RangesPort() {
  return {"ranges",
          {{"range",
            {IntegerArgument("sensor"), RealArgument("gap", "m")},
            "from the rim to what stands there; sensor 0 looks ahead, they count to the left"}},
          "range finders; every tick"};
}

PortSpec TouchPort() {
  return {"touch",
          {{"bump",
            {SymbolArgument("side")},
            "ahead, left, right or behind: the rim touches something"}},
          "the bumper; every tick"};
}

PortSpec PowerPort() {
  return {"power",
          {{"battery", {RealArgument("charge", "")}, "1 full, 0 empty"},
           {"charging", {}, "the robot stands on its dock"}},
          "every tick"};
}

}  // namespace

sdk::Contract CleaningContract() {
  return {{DrivePort()},
          {RobotPort(), PosePort(), ViewPort(), RangesPort(), TouchPort(), PowerPort()}};
}

std::vector<PredicateSpec> CleaningEvents() {
  return {{"box_put",
           {RealArgument("x", "m"), RealArgument("y", "m")},
           "a box of 0.5 m is put down; its middle is the nearest corner of tiles"},
          {"dirt_spilled",
           {RealArgument("x", "m"), RealArgument("y", "m"), RealArgument("radius", "m")},
           "the tiles around a place are dirty again"}};
}

std::vector<ParameterSpec> CleaningParameters() {
  ParameterSpec plan;
  plan.name = "plan";
  plan.type = ParameterType::kFile;
  plan.default_value = "";
  plan.help = "a floor plan as text; empty: the shipped floor of offices";
  ParameterSpec boxes;
  boxes.name = "boxes";
  boxes.type = ParameterType::kInteger;
  boxes.default_value = "5";
  boxes.minimum = 0;
  boxes.maximum = 50;
  boxes.help = "boxes of 0.5 m that stand about, by seed";
  return {
      std::move(plan),
      std::move(boxes),
      RealParameter("target", "0.95", 0, 1, "", "part of the floor in reach that is to be clean"),
      RealParameter("capacity", "30000", 100, 1e7, "J", "of the battery"),
      RealParameter("idle_power", "8", 0, 1000, "W", "of the robot that stands"),
      RealParameter("brush_power", "22", 0, 1000, "W", "of the brush, which turns off the dock"),
      RealParameter("drive_power", "40", 0, 1000, "W/(m/s)", "of the wheels"),
      RealParameter("dock_power", "300", 1, 10000, "W", "that the dock gives"),
      RealParameter("radius", "0.3", 0.15, 0.37, "m", "of the robot"),
      RealParameter("brush", "0.37", 0.1, 0.5, "m", "radius that the brush sweeps"),
      RealParameter("max_speed", "0.5", 0.1, 2, "m/s", "of the robot"),
      RealParameter("sight", "1.1", 0.5, 3, "m", "how far it sees the floor"),
      RealParameter("picture_period", "0.4", 0.01, 10, "s", "between two pictures of the floor"),
      RealParameter("overlooked", "0.02", 0, 0.9, "",
                    "part of the dirty tiles that a picture shows clean"),
      RealParameter("pose_noise", "0.01", 0, 0.2, "m", "standard deviation, for x and for y"),
      RealParameter("heading_noise", "0.01", 0, 0.2, "rad", "standard deviation"),
      RealParameter("range_noise", "0.01", 0, 0.5, "m", "standard deviation")};
}

}  // namespace latchwork::cleaning

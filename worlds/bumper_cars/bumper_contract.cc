// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/bumper_contract.h"

#include <utility>

#include "latchwork/sdk/specs.h"

namespace latchwork::bumper_cars {
namespace {

using sdk::IntegerArgument;
using sdk::IntegerParameter;
using sdk::ParameterSpec;
using sdk::ParameterType;
using sdk::PortSpec;
using sdk::RealArgument;
using sdk::RealParameter;
using sdk::SymbolArgument;

PortSpec TaskPort() {
  return {.name = "task",
          .predicates =
              {{"task", {SymbolArgument("task")}, "collision or day"},
               {"today", {SymbolArgument("day")}, "which day it is"},
               {"spills_wanted", {IntegerArgument("count")}, "hard bumps to be had in a day"},
               {"thrills_wanted", {IntegerArgument("count")}, "fast seconds to be had in a day"}},
          .help = "what the run is about; at tick 0"};
}

PortSpec PlacesPort() {
  return {.name = "places",
          .predicates =
              {{"arena", {RealArgument("width", "m"), RealArgument("height", "m")}, "from (0, 0)"},
               {"pole",
                {SymbolArgument("pole"), RealArgument("x", "m"), RealArgument("y", "m")},
                "gives power"},
               {"gate", {RealArgument("x", "m"), RealArgument("y", "m")}, "where cars are left"}},
          .help = "what does not move; at tick 0"};
}

PortSpec PeoplePort() {
  return {.name = "people",
          .predicates = {{"driver",
                          {SymbolArgument("car"), SymbolArgument("person")},
                          "who drives which car"},
                         {"enemy", {SymbolArgument("person")}, "to be rammed"},
                         {"friend", {SymbolArgument("person")}, "to be tapped at most"}},
          .help = "of the other cars; at tick 0"};
}

PortSpec SelfPort() {
  return {.name = "self",
          .predicates = {{"pose",
                          {RealArgument("x", "m"), RealArgument("y", "m"),
                           RealArgument("heading", "rad")},
                          "in the arena, counter-clockwise from the x axis"},
                         {"speed", {RealArgument("speed", "m/s")}, "along the heading"},
                         {"power", {SymbolArgument("state")}, "on, or off: the motor is weak"}},
          .help = "the agent's own car; every tick"};
}

PortSpec EyesPort() {
  return {.name = "eyes",
          .predicates = {{"sees",
                          {SymbolArgument("car"), RealArgument("distance", "m"),
                           RealArgument("bearing", "rad")},
                          "between the centres, with noise; left > 0"}},
          .help = "other cars in the field of view; every tick"};
}

PortSpec FeelersPort() {
  return {.name = "feelers",
          .predicates = {{"clear",
                          {SymbolArgument("side"), RealArgument("distance", "m")},
                          "ahead, left, right: from the rim to a wall or pole"}},
          .help = "every tick; left and right are 0.7 rad from ahead"};
}

PortSpec TouchPort() {
  return {.name = "touch",
          .predicates = {{"touching", {SymbolArgument("thing")}, "a car, a pole, or wall"}},
          .help = "what the ring of rubber feels; every tick"};
}

PortSpec ScorePort() {
  return {.name = "score",
          .predicates = {{"rammed", {SymbolArgument("car")}, "an enemy's, hard enough"},
                         {"tapped", {SymbolArgument("car")}, "a friend's, softly enough"},
                         {"spill_count", {IntegerArgument("count")}, "hard bumps so far"},
                         {"thrill_count", {IntegerArgument("count")}, "fast seconds so far"},
                         {"paid", {}, "the ride has begun"},
                         {"ride_over", {}, "the bell has rung"},
                         {"outside", {}, "the agent has left"}},
          .help = "how the run stands; when it changes"};
}

}  // namespace

sdk::Contract BumperContract() {
  PortSpec drive{
      .name = "drive",
      .predicates = {{"pedal", {RealArgument("percent", "%")}, "of the highest speed; < 0 back"},
                     {"steer", {RealArgument("angle", "rad")}, "of the wheel, left > 0"}},
      .help = "what the car is told; nothing: it brakes, wheel straight",
      .optional = true};
  PortSpec gate{.name = "gate",
                .predicates = {{"pay", {}, "for a ride; takes 2 s"},
                               {"leave", {}, "the standing car, near the gate; takes 2 s"}},
                .help = "what is done at the gate",
                .optional = true};
  return {.inputs = {std::move(drive), std::move(gate)},
          .outputs = {TaskPort(), PlacesPort(), PeoplePort(), SelfPort(), EyesPort(), FeelersPort(),
                      TouchPort(), ScorePort()}};
}

std::vector<ParameterSpec> BumperParameters() {
  ParameterSpec task{.name = "task",
                     .type = ParameterType::kText,
                     .default_value = "collision",
                     .unit = "",
                     .help = "collision: ram and tap; day: pay, ride, leave",
                     .choices = {"collision", "day"}};
  ParameterSpec day{.name = "day",
                    .type = ParameterType::kText,
                    .default_value = "monday",
                    .unit = "",
                    .help = "which day it is",
                    .choices = {}};
  return {std::move(task),
          std::move(day),
          RealParameter("width", "16", 6, 100, "m", "of the arena"),
          RealParameter("height", "10", 6, 100, "m", "of the arena"),
          IntegerParameter("poles", "2", 1, 4, "that give power"),
          IntegerParameter("enemies", "2", 0, 8, "in cars of their own"),
          IntegerParameter("friends", "2", 0, 8, "in cars of their own"),
          IntegerParameter("strangers", "1", 0, 8, "in cars of their own"),
          RealParameter("charge", "40", 1, 1e6, "s", "of driving with the pedal down"),
          RealParameter("field_of_view", "200", 10, 360, "deg", "of the eyes"),
          RealParameter("sight", "12", 1, 200, "m", "how far the eyes see"),
          RealParameter("sight_noise", "0.03", 0, 1, "",
                        "deviation of a distance, in parts; of a bearing, "
                        "rad"),
          IntegerParameter("rams", "1", 0, 8, "different enemies to ram"),
          IntegerParameter("taps", "0", 0, 8, "different friends to tap"),
          RealParameter("ram_speed", "1.0", 0.1, 2, "m/s", "at least, for a ram or a spill"),
          RealParameter("tap_speed", "0.8", 0.1, 2, "m/s", "at most, into a friend"),
          RealParameter("ride_time", "90", 1, 1e5, "s", "from paying to the bell"),
          IntegerParameter("spills", "3", 0, 1000, "hard bumps that make a day"),
          IntegerParameter("thrills", "5", 0, 1000, "seconds at 1.6 m/s or more that make a day")};
}

std::vector<sdk::PredicateSpec> BumperEvents() {
  return {{"power_fails", {SymbolArgument("car")}, "its charge is gone; the agent's car is 'me'"},
          {"stalls", {SymbolArgument("car")}, "its motor stops"},
          {"drives_on", {SymbolArgument("car")}, "its motor runs again"},
          {"bell", {}, "the ride is over now"}};
}

}  // namespace latchwork::bumper_cars

// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/bumper_cars/bumper_contract.h"

#include <utility>

namespace latchwork::bumper_cars {
namespace {

using sdk::ArgumentSpec;
using sdk::ArgumentType;
using sdk::ParameterSpec;
using sdk::ParameterType;
using sdk::PortSpec;

ArgumentSpec Word(const char* name) { return {name, ArgumentType::kSymbol, ""}; }
ArgumentSpec Count(const char* name) { return {name, ArgumentType::kInteger, ""}; }
ArgumentSpec Real(const char* name, const char* unit) { return {name, ArgumentType::kReal, unit}; }

ParameterSpec Number(const char* name, const char* value, double low, double high, const char* unit,
                     const char* help) {
  return {.name = name,
          .default_value = value,
          .minimum = low,
          .maximum = high,
          .unit = unit,
          .help = help,
          .choices = {}};
}

ParameterSpec Whole(const char* name, const char* value, double low, double high,
                    const char* help) {
  ParameterSpec spec = Number(name, value, low, high, "", help);
  spec.type = ParameterType::kInteger;
  return spec;
}

PortSpec TaskPort() {
  return {.name = "task",
          .predicates = {{"task", {Word("task")}, "collision or day"},
                         {"today", {Word("day")}, "which day it is"},
                         {"spills_wanted", {Count("count")}, "hard bumps to be had in a day"},
                         {"thrills_wanted", {Count("count")}, "fast seconds to be had in a day"}},
          .help = "what the run is about; at tick 0"};
}

PortSpec PlacesPort() {
  return {.name = "places",
          .predicates = {{"arena", {Real("width", "m"), Real("height", "m")}, "from (0, 0)"},
                         {"pole", {Word("pole"), Real("x", "m"), Real("y", "m")}, "gives power"},
                         {"gate", {Real("x", "m"), Real("y", "m")}, "where cars are left"}},
          .help = "what does not move; at tick 0"};
}

PortSpec PeoplePort() {
  return {.name = "people",
          .predicates = {{"driver", {Word("car"), Word("person")}, "who drives which car"},
                         {"enemy", {Word("person")}, "to be rammed"},
                         {"friend", {Word("person")}, "to be tapped at most"}},
          .help = "of the other cars; at tick 0"};
}

PortSpec SelfPort() {
  return {.name = "self",
          .predicates = {{"pose",
                          {Real("x", "m"), Real("y", "m"), Real("heading", "rad")},
                          "in the arena, counter-clockwise from the x axis"},
                         {"speed", {Real("speed", "m/s")}, "along the heading"},
                         {"power", {Word("state")}, "on, or off: the motor is weak"}},
          .help = "the agent's own car; every tick"};
}

PortSpec EyesPort() {
  return {.name = "eyes",
          .predicates = {{"sees",
                          {Word("car"), Real("distance", "m"), Real("bearing", "rad")},
                          "between the centres, with noise; left > 0"}},
          .help = "other cars in the field of view; every tick"};
}

PortSpec FeelersPort() {
  return {.name = "feelers",
          .predicates = {{"clear",
                          {Word("side"), Real("distance", "m")},
                          "ahead, left, right: from the rim to a wall or pole"}},
          .help = "every tick; left and right are 0.7 rad from ahead"};
}

PortSpec TouchPort() {
  return {.name = "touch",
          .predicates = {{"touching", {Word("thing")}, "a car, a pole, or wall"}},
          .help = "what the ring of rubber feels; every tick"};
}

PortSpec ScorePort() {
  return {.name = "score",
          .predicates = {{"rammed", {Word("car")}, "an enemy's, hard enough"},
                         {"tapped", {Word("car")}, "a friend's, softly enough"},
                         {"spill_count", {Count("count")}, "hard bumps so far"},
                         {"thrill_count", {Count("count")}, "fast seconds so far"},
                         {"paid", {}, "the ride has begun"},
                         {"ride_over", {}, "the bell has rung"},
                         {"outside", {}, "the agent has left"}},
          .help = "how the run stands; when it changes"};
}

}  // namespace

sdk::Contract BumperContract() {
  PortSpec drive{.name = "drive",
                 .predicates = {{"pedal", {Real("percent", "%")}, "of the highest speed; < 0 back"},
                                {"steer", {Real("angle", "rad")}, "of the wheel, left > 0"}},
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
          Number("width", "16", 6, 100, "m", "of the arena"),
          Number("height", "10", 6, 100, "m", "of the arena"),
          Whole("poles", "2", 1, 4, "that give power"),
          Whole("enemies", "2", 0, 8, "in cars of their own"),
          Whole("friends", "2", 0, 8, "in cars of their own"),
          Whole("strangers", "1", 0, 8, "in cars of their own"),
          Number("charge", "40", 1, 1e6, "s", "of driving with the pedal down"),
          Number("field_of_view", "200", 10, 360, "deg", "of the eyes"),
          Number("sight", "12", 1, 200, "m", "how far the eyes see"),
          Number("sight_noise", "0.03", 0, 1, "",
                 "deviation of a distance, in parts; of a bearing, "
                 "rad"),
          Whole("rams", "1", 0, 8, "different enemies to ram"),
          Whole("taps", "0", 0, 8, "different friends to tap"),
          Number("ram_speed", "1.0", 0.1, 2, "m/s", "at least, for a ram or a spill"),
          Number("tap_speed", "0.8", 0.1, 2, "m/s", "at most, into a friend"),
          Number("ride_time", "90", 1, 1e5, "s", "from paying to the bell"),
          Whole("spills", "3", 0, 1000, "hard bumps that make a day"),
          Whole("thrills", "5", 0, 1000, "seconds at 1.6 m/s or more that make a day")};
}

std::vector<sdk::PredicateSpec> BumperEvents() {
  return {{"power_fails", {Word("car")}, "its charge is gone; the agent's car is 'me'"},
          {"stalls", {Word("car")}, "its motor stops"},
          {"drives_on", {Word("car")}, "its motor runs again"},
          {"bell", {}, "the ride is over now"}};
}

}  // namespace latchwork::bumper_cars

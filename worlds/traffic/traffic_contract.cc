// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/traffic/traffic_contract.h"

#include <string>
#include <utility>

#include "latchwork/sdk/specs.h"

namespace latchwork::traffic {

namespace {

using sdk::ArgumentSpec;
using sdk::ArgumentType;
using sdk::IntegerParameter;
using sdk::ParameterSpec;
using sdk::ParameterType;
using sdk::PortSpec;
using sdk::RealArgument;
using sdk::RealParameter;

ArgumentSpec Lane(std::string name = "lane") {
  return {std::move(name), ArgumentType::kInteger, {}};
}
ArgumentSpec Name() { return {"car", ArgumentType::kSymbol, {}}; }

PortSpec DrivePort() {
  return {"drive",
          {{"accelerate", {RealArgument("acceleration", "m/s^2")}, "negative: brake; -8 to 3"},
           {"aim", {Lane()}, "steer for the middle of this lane; crossing one takes about 4 s"}},
          "pedals and steering; nothing: the car rolls on in its lane",
          true};
}

PortSpec SelfPort() {
  return {"self",
          {{"my_lane", {Lane()}, "the nearest; 0 is the rightmost, the one with the exits"},
           {"my_aim", {Lane()}, "the lane that the car steers for"},
           {"my_offset", {RealArgument("offset", "m")}, "from the middle of my_lane, left > 0"},
           {"in_lane", {Lane()}, "a lane that the car takes up; between lanes there are two"},
           {"my_speed", {RealArgument("speed", "m/s")}, "as the speedometer shows it"},
           {"exit_in", {RealArgument("distance", "m")}, "until the exit that is to be taken"},
           {"trip", {{"number", ArgumentType::kInteger, {}}}, "from 1 on; see trips"}},
          "the agent's car; every tick"};
}

PortSpec CarsPort() {
  const std::vector<ArgumentSpec> seen = {Lane(), Name(), RealArgument("gap", "m"),
                                          RealArgument("relative_speed", "m/s")};
  return {"cars",
          {{"ahead", seen, "the next car in a lane, bumper to bumper; > 0: it draws away"},
           {"behind", seen, "the next car behind in a lane; > 0: it comes nearer"},
           {"beside", {Lane(), Name()}, "a car in a lane that is neither ahead nor behind"}},
          "who is in sight, in each lane; every tick. A car between lanes is in both"};
}

PortSpec RoadPort() {
  return {"road",
          {{"lane", {Lane()}, "there is such a lane"},
           {"left_of", {Lane("left"), Lane()}, "the lane to the left of a lane"},
           {"speed_limit", {RealArgument("speed", "m/s")}, "on this road"}},
          "what does not change; at tick 0"};
}

PortSpec RewardPort() {
  return {"reward",
          {{"reward", {RealArgument("reward", "")}, "of the last tick: progress less discomfort"}},
          "for an agent that learns; every tick"};
}

}  // namespace

sdk::Contract TrafficContract() {
  return {{DrivePort()}, {SelfPort(), CarsPort(), RoadPort(), RewardPort()}};
}

std::vector<sdk::PredicateSpec> TrafficEvents() {
  return {
      {"brakes", {Name(), RealArgument("duration", "s")}, "a car brakes hard, for whatever reason"},
      {"leader_brakes",
       {RealArgument("duration", "s")},
       "so does the car ahead in the agent's lane"},
      {"sight", {RealArgument("range", "m")}, "from now on cars are seen as far as this"},
  };
}

std::vector<ParameterSpec> TrafficParameters() {
  ParameterSpec end{.name = "end_at_failure",
                    .type = ParameterType::kBoolean,
                    .default_value = "true",
                    .unit = {},
                    .help = "a collision, a missed exit or a trip that takes too long ends the run",
                    .choices = {}};
  return {
      IntegerParameter("lanes", "3", 1, 6, "of the road, one way"),
      RealParameter("ring", "2000", 500, 20000, "m", "the road is a ring of this length"),
      RealParameter("density", "8", 0, 30, "1/km", "cars per lane, at least one in each"),
      RealParameter("trucks", "0.15", 0, 1, "",
                    "share of the cars that are long and slow; not leftmost"),
      RealParameter("speed_limit", "30", 5, 50, "m/s", "others like 60 to 115 % of it"),
      RealParameter("exit", "1500", 100, 100000, "m",
                    "length of a trip, from its start to its exit"),
      RealParameter("slack", "1.4", 1, 100, "",
                    "good time: at most so many times what a trip takes at the speed limit"),
      IntegerParameter("trips", "1", 1, 100000,
                       "until the run ends; each starts where the last one ended"),
      std::move(end),
      RealParameter("sight_range", "150", 20, 500, "m", "how far cars are seen, ahead and behind"),
      RealParameter("distance_noise", "0.3", 0, 5, "m", "standard deviation of gaps"),
      RealParameter("speed_noise", "0.2", 0, 5, "m/s", "standard deviation of relative speeds"),
      RealParameter("brakings", "0.2", 0, 10, "1/min",
                    "how often the car ahead brakes hard for 2 s for no reason"),
      RealParameter("warm_up", "30", 0, 600, "s", "that the traffic flows before tick 0"),
  };
}

}  // namespace latchwork::traffic

// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/garden/garden_contract.h"

#include <string>
#include <utility>

#include "latchwork/sdk/specs.h"

namespace latchwork::garden {

namespace {

using sdk::IntegerArgument;
using sdk::IntegerParameter;
using sdk::ParameterSpec;
using sdk::PortSpec;
using sdk::PredicateSpec;
using sdk::RealArgument;
using sdk::RealParameter;
using sdk::SymbolArgument;

PortSpec WorkPort() {
  return {"work",
          {{"walk", {SymbolArgument("place")}, "to a bed or to the well, for as long as it takes"},
           {"fill", {}, "at the well: the tank, from the barrel"},
           {"pour", {}, "at a bed: water, from the tank"},
           {"feed", {}, "at a bed: a portion of food; takes 5 minutes"},
           {"cover", {}, "the bed here, against frost and rain; takes 10 minutes"},
           {"uncover", {}, "the bed here; takes 10 minutes"}},
          "what the gardener does; the first fact counts; nothing: it rests",
          true};
}

PortSpec MapPort() {
  return {"map",
          {{"bed",
            {SymbolArgument("bed"), RealArgument("way", "m")},
            "how far along the path it lies"}},
          "the beds; at tick 0"};
}

PortSpec ClockPort() {
  return {"clock",
          {{"day", {IntegerArgument("day")}, "of the season, from 0"},
           {"hour", {RealArgument("hour", "h")}, "since midnight"},
           {"working", {}, "the gardener works: from 6 to 20 o'clock"}},
          "every tick"};
}

PortSpec WeatherPort() {
  return {"weather",
          {{"sky", {SymbolArgument("sky")}, "sun, cloud or rain"},
           {"temperature", {RealArgument("degrees", "C")}, "of the air"}},
          "every tick"};
}

PortSpec ForecastPort() {
  return {"forecast",
          {{"rain_expected",
            {IntegerArgument("days_ahead"), RealArgument("rain", "mm")},
            "of the whole day: 0 today, 1 tomorrow"},
           {"low_expected", {RealArgument("degrees", "C")}, "in the coming night"}},
          "what to expect; errs a little; at midnight"};
}

PortSpec BedsPort() {
  return {"beds",
          {{"soil",
            {SymbolArgument("bed"), RealArgument("moisture", "")},
            "0 dry, 1 full of water; noisy"},
           {"covered", {SymbolArgument("bed")}, "it lies under its cover"}},
          "probes in the soil; every tick"};
}

PortSpec InspectionPort() {
  return {
      "inspection",
      {{"at", {SymbolArgument("place")}, "where the gardener is; nothing on its way"},
       {"food", {SymbolArgument("bed"), RealArgument("food", "g")}, "in the soil of the bed here"},
       {"pumpkin",
        {SymbolArgument("bed"), IntegerArgument("number"), RealArgument("weight", "kg"),
         RealArgument("health", "")},
        "a plant of the bed here; health from 1 to 0, dead"}},
      "what the gardener sees where it is; every tick"};
}

PortSpec StockPort() {
  return {"stock",
          {{"tank", {RealArgument("water", "l")}, "that the gardener carries"},
           {"barrel", {RealArgument("water", "l")}, "at the well"},
           {"portions", {IntegerArgument("portions")}, "of food that are left"}},
          "every tick"};
}

}  // namespace

sdk::Contract GardenContract() {
  return {{WorkPort()},
          {MapPort(), ClockPort(), WeatherPort(), ForecastPort(), BedsPort(), InspectionPort(),
           StockPort()}};
}

std::vector<PredicateSpec> GardenEvents() {
  return {{"spring_gives",
           {RealArgument("litres", "l/h")},
           "how much water runs into the barrel from now on"},
          {"food_delivered", {IntegerArgument("portions")}, "more food"},
          {"slugs",
           {SymbolArgument("bed"), RealArgument("harm", "")},
           "every plant of the bed loses that much health"}};
}

std::vector<ParameterSpec> GardenParameters() {
  return {IntegerParameter("days", "70", 1, 365, "of the season"),
          IntegerParameter("beds", "6", 1, 40, "along the path"),
          IntegerParameter("plants", "3", 1, 20, "in each bed"),
          IntegerParameter("portions", "50", 0, 10000, "of food for the season"),
          RealParameter("goal_weight", "440", 0, 1e6, "kg",
                        "that all pumpkins together have at the end of the season"),
          RealParameter("barrel", "400", 0, 1e5, "l", "that the barrel at the well holds"),
          RealParameter("spring", "10", 0, 1e3, "l/h", "that run into the barrel"),
          RealParameter("tank", "40", 1, 1e3, "l", "that the gardener carries"),
          RealParameter("speed", "0.25", 0.01, 3, "m/s", "of the gardener"),
          RealParameter("probe_noise", "0.02", 0, 0.3, "",
                        "standard deviation of the soil's moisture")};
}

}  // namespace latchwork::garden

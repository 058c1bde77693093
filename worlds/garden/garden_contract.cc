// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/garden/garden_contract.h"

#include <string>
#include <utility>

namespace latchwork::garden {

namespace {

using sdk::ArgumentSpec;
using sdk::ArgumentType;
using sdk::ParameterSpec;
using sdk::ParameterType;
using sdk::PortSpec;
using sdk::PredicateSpec;

ArgumentSpec Integer(std::string name) { return {std::move(name), ArgumentType::kInteger, {}}; }
ArgumentSpec Real(std::string name, std::string unit) {
  return {std::move(name), ArgumentType::kReal, std::move(unit)};
}
ArgumentSpec Word(std::string name) { return {std::move(name), ArgumentType::kSymbol, {}}; }

PortSpec WorkPort() {
  return {"work",
          {{"walk", {Word("place")}, "to a bed or to the well, for as long as it takes"},
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
          {{"bed", {Word("bed"), Real("way", "m")}, "how far along the path it lies"}},
          "the beds; at tick 0"};
}

PortSpec ClockPort() {
  return {"clock",
          {{"day", {Integer("day")}, "of the season, from 0"},
           {"hour", {Real("hour", "h")}, "since midnight"},
           {"working", {}, "the gardener works: from 6 to 20 o'clock"}},
          "every tick"};
}

PortSpec WeatherPort() {
  return {"weather",
          {{"sky", {Word("sky")}, "sun, cloud or rain"},
           {"temperature", {Real("degrees", "C")}, "of the air"}},
          "every tick"};
}

PortSpec ForecastPort() {
  return {"forecast",
          {{"rain_expected",
            {Integer("days_ahead"), Real("rain", "mm")},
            "of the whole day: 0 today, 1 tomorrow"},
           {"low_expected", {Real("degrees", "C")}, "in the coming night"}},
          "what to expect; errs a little; at midnight"};
}

PortSpec BedsPort() {
  return {"beds",
          {{"soil", {Word("bed"), Real("moisture", "")}, "0 dry, 1 full of water; noisy"},
           {"covered", {Word("bed")}, "it lies under its cover"}},
          "probes in the soil; every tick"};
}

PortSpec InspectionPort() {
  return {"inspection",
          {{"at", {Word("place")}, "where the gardener is; nothing on its way"},
           {"food", {Word("bed"), Real("food", "g")}, "in the soil of the bed here"},
           {"pumpkin",
            {Word("bed"), Integer("number"), Real("weight", "kg"), Real("health", "")},
            "a plant of the bed here; health from 1 to 0, dead"}},
          "what the gardener sees where it is; every tick"};
}

PortSpec StockPort() {
  return {"stock",
          {{"tank", {Real("water", "l")}, "that the gardener carries"},
           {"barrel", {Real("water", "l")}, "at the well"},
           {"portions", {Integer("portions")}, "of food that are left"}},
          "every tick"};
}

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
  ParameterSpec spec = Number(std::move(name), std::move(value), low, high, {}, std::move(help));
  spec.type = ParameterType::kInteger;
  return spec;
}

}  // namespace

sdk::Contract GardenContract() {
  return {{WorkPort()},
          {MapPort(), ClockPort(), WeatherPort(), ForecastPort(), BedsPort(), InspectionPort(),
           StockPort()}};
}

std::vector<PredicateSpec> GardenEvents() {
  return {
      {"spring_gives", {Real("litres", "l/h")}, "how much water runs into the barrel from now on"},
      {"food_delivered", {Integer("portions")}, "more food"},
      {"slugs", {Word("bed"), Real("harm", "")}, "every plant of the bed loses that much health"}};
}

std::vector<ParameterSpec> GardenParameters() {
  return {Count("days", "70", 1, 365, "of the season"),
          Count("beds", "6", 1, 40, "along the path"),
          Count("plants", "3", 1, 20, "in each bed"),
          Count("portions", "50", 0, 10000, "of food for the season"),
          Number("goal_weight", "440", 0, 1e6, "kg",
                 "that all pumpkins together have at the end of the season"),
          Number("barrel", "400", 0, 1e5, "l", "that the barrel at the well holds"),
          Number("spring", "10", 0, 1e3, "l/h", "that run into the barrel"),
          Number("tank", "40", 1, 1e3, "l", "that the gardener carries"),
          Number("speed", "0.25", 0.01, 3, "m/s", "of the gardener"),
          Number("probe_noise", "0.02", 0, 0.3, "", "standard deviation of the soil's moisture")};
}

}  // namespace latchwork::garden

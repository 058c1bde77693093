// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/bumper_driver/bumper_driver_layer.h"

#include <utility>

#include "latchwork/sdk/contract_body.h"
#include "latchwork/sdk/specs.h"
#include "plugins/bumper_driver/sight.h"

namespace latchwork::bumper_driver {
namespace {

using sdk::IntegerArgument;
using sdk::ParameterSpec;
using sdk::ParameterType;
using sdk::PortSpec;
using sdk::RealArgument;
using sdk::SymbolArgument;

std::vector<PortSpec> MakeInputs() {
  return {{.name = "task",
           .predicates = {{"task", {SymbolArgument("task")}, "collision or day"},
                          {"today", {SymbolArgument("day")}, "which day it is"},
                          {"spills_wanted", {IntegerArgument("count")}, "hard bumps to be had"},
                          {"thrills_wanted", {IntegerArgument("count")}, "fast seconds to be had"}},
           .help = "what is to be done"},
          {.name = "places",
           .predicates = {{"pole",
                           {SymbolArgument("pole"), RealArgument("x", "m"), RealArgument("y", "m")},
                           "gives power"},
                          {"gate",
                           {RealArgument("x", "m"), RealArgument("y", "m")},
                           "where cars are left"}},
           .help = "what does not move"},
          {.name = "people",
           .predicates = {{"driver",
                           {SymbolArgument("car"), SymbolArgument("person")},
                           "who drives which car"},
                          {"enemy", {SymbolArgument("person")}, "to be rammed"},
                          {"friend", {SymbolArgument("person")}, "to be tapped at most"}},
           .help = "in the other cars"},
          {.name = "self",
           .predicates = {{"pose",
                           {RealArgument("x", "m"), RealArgument("y", "m"),
                            RealArgument("heading", "rad")},
                           ""},
                          {"speed", {RealArgument("speed", "m/s")}, "along the heading"},
                          {"power", {SymbolArgument("state")}, "on or off"}},
           .help = "the own car"},
          {.name = "eyes",
           .predicates = {{"sees",
                           {SymbolArgument("car"), RealArgument("distance", "m"),
                            RealArgument("bearing", "rad")},
                           "left > 0"}},
           .help = "other cars in view"},
          {.name = "feelers",
           .predicates = {{"clear",
                           {SymbolArgument("side"), RealArgument("distance", "m")},
                           "ahead, left, right"}},
           .help = "to walls and poles"},
          {.name = "touch",
           .predicates = {{"touching", {SymbolArgument("thing")}, "a car, a pole, or wall"}},
           .help = "what the rubber ring feels"},
          {.name = "score",
           .predicates = {{"rammed", {SymbolArgument("car")}, "an enemy's, hard enough"},
                          {"tapped", {SymbolArgument("car")}, "a friend's, softly enough"},
                          {"spill_count", {IntegerArgument("count")}, "hard bumps so far"},
                          {"thrill_count", {IntegerArgument("count")}, "fast seconds so far"},
                          {"paid", {}, "the ride has begun"},
                          {"ride_over", {}, "the bell has rung"},
                          {"outside", {}, "the car was left"}},
           .help = "how things stand"}};
}

sdk::Contract MakeContract() {
  PortSpec drive{
      .name = "drive",
      .predicates = {{"pedal", {RealArgument("percent", "%")}, "of the highest speed; < 0 back"},
                     {"steer", {RealArgument("angle", "rad")}, "of the wheel, left > 0"}},
      .help = "what the car is told"};
  PortSpec gate{.name = "gate",
                .predicates = {{"pay", {}, "for a ride"}, {"leave", {}, "the standing car"}},
                .help = "what is done at the gate"};
  return {MakeInputs(), {std::move(drive), std::move(gate)}};
}

}  // namespace

const sdk::Contract& BumperDriverLayer::contract() const {
  static const sdk::Contract contract = MakeContract();
  return contract;
}

std::span<const ParameterSpec> BumperDriverLayer::parameters() const {
  static const std::vector<ParameterSpec> parameters{
      {.name = "plan",
       .type = ParameterType::kText,
       .default_value = "skill",
       .unit = "",
       .help = "how a collision is brought about: as a skill (table 1 of the paper), as a "
               "teleo-reactive tree (table 5), as a universal plan (figure 2)",
       .choices = {"skill", "tree", "universal"}}};
  return parameters;
}

sdk::Body BumperDriverLayer::MakeBody(std::string_view language, const sdk::Parameters& parameters,
                                      const std::filesystem::path& data,
                                      logic::SymbolTable& symbols) const {
  sdk::Body body = sdk::ContractBody(contract(), language, symbols);
  body.files = {data / "bumper_driver.icarus"};
  body.facts = sdk::ParameterFacts(parameters, symbols);
  body.attachments = SightAttachments();
  return body;
}

}  // namespace latchwork::bumper_driver

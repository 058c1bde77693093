// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/lane_driver/lane_driver_layer.h"

#include <memory>
#include <utility>

#include "latchwork/sdk/contract_body.h"
#include "latchwork/sdk/specs.h"
#include "plugins/lane_driver/pace.h"

namespace latchwork::lane_driver {
namespace {

using sdk::ArgumentSpec;
using sdk::ArgumentType;
using sdk::ParameterSpec;
using sdk::ParameterType;
using sdk::PortSpec;
using sdk::RealParameter;

const ArgumentSpec kLane{"lane", ArgumentType::kInteger, ""};
const ArgumentSpec kCar{"car", ArgumentType::kSymbol, ""};
const ArgumentSpec kSpeed{"speed", ArgumentType::kReal, "m/s"};

sdk::Contract MakeContract() {
  const std::vector<ArgumentSpec> seen = {kLane,
                                          kCar,
                                          {"gap", ArgumentType::kReal, "m"},
                                          {"relative_speed", ArgumentType::kReal, "m/s"}};
  PortSpec self{.name = "self",
                .predicates = {{"my_lane", {kLane}, "the nearest; 0 is the rightmost"},
                               {"my_aim", {kLane}, "the lane that the car steers for"},
                               {"my_offset",
                                {{"offset", ArgumentType::kReal, "m"}},
                                "from the middle of my_lane, left > 0"},
                               {"in_lane", {kLane}, "a lane that the car takes up"},
                               {"my_speed", {kSpeed}, ""},
                               {"exit_in", {{"distance", ArgumentType::kReal, "m"}}, "to the exit"},
                               {"trip", {{"number", ArgumentType::kInteger, ""}}, "from 1 on"}},
                .help = "the own car"};
  PortSpec cars{.name = "cars",
                .predicates = {{"ahead", seen, "the next car in a lane; > 0: it draws away"},
                               {"behind", seen, "the next car behind; > 0: it comes nearer"},
                               {"beside", {kLane, kCar}, "neither ahead nor behind"}},
                .help = "the other cars in sight"};
  PortSpec road{.name = "road",
                .predicates = {{"lane", {kLane}, "there is such a lane"},
                               {"left_of",
                                {{"left", ArgumentType::kInteger, ""}, kLane},
                                "the lane to the left of a lane"},
                               {"speed_limit", {kSpeed}, "also the speed that is wanted"}},
                .help = "the road"};
  PortSpec reward{.name = "reward",
                  .predicates = {{"reward", {{"reward", ArgumentType::kReal, ""}}, "of a tick"}},
                  .help = "for reasoners that learn",
                  .optional = true};
  PortSpec drive{.name = "drive",
                 .predicates = {{"accelerate",
                                 {{"acceleration", ArgumentType::kReal, "m/s^2"}},
                                 "negative: brake"},
                                {"aim", {kLane}, "steer for the middle of this lane"}},
                 .help = "pedals and steering"};
  return {{std::move(self), std::move(cars), std::move(road), std::move(reward)},
          {std::move(drive)}};
}

std::vector<ParameterSpec> MakeParameters() {
  return {
      RealParameter("headway", "1.2", 0.3, 5, "s", "to the car ahead when following it"),
      RealParameter("standstill_gap", "3", 0.5, 20, "m", "to the car ahead at a stand"),
      RealParameter("exit_zone", "300", 50, 5000, "m",
                    "before the exit, where lane 0 is not left again"),
      RealParameter("lane_zone", "250", 50, 5000, "m",
                    "more of it for every lane that is to be crossed"),
      {.name = "passing",
       .type = ParameterType::kText,
       .default_value = "fastest",
       .unit = {},
       .help = "a slow car ahead: take the fastest lane, or the first of left, right, stay behind "
               "(free: the means among which a reasoner may learn to choose), or never pass it",
       .choices = {"fastest", "free", "never"}},
  };
}

}  // namespace

const sdk::Contract& LaneDriverLayer::contract() const {
  static const sdk::Contract contract = MakeContract();
  return contract;
}

std::span<const ParameterSpec> LaneDriverLayer::parameters() const {
  static const std::vector<ParameterSpec> parameters = MakeParameters();
  return parameters;
}

sdk::Body LaneDriverLayer::MakeBody(std::string_view language, const sdk::Parameters& parameters,
                                    const std::filesystem::path& data,
                                    logic::SymbolTable& symbols) const {
  sdk::Body body = sdk::ContractBody(contract(), language, symbols);
  body.files = {data / "lane_driver.icarus"};
  body.facts = sdk::ParameterFacts(parameters, symbols);
  const Pace::Habits habits{.headway = parameters.Real("headway"),
                            .standstill_gap = parameters.Real("standstill_gap")};
  body.attachments = {std::make_shared<Pace>(habits), std::make_shared<FreePace>(),
                      std::make_shared<BrakingNeeded>()};
  return body;
}

std::vector<sdk::Fallback> LaneDriverLayer::fallbacks(logic::SymbolTable& symbols) const {
  return {{0, {logic::Fact(symbols.Intern("accelerate"), {logic::Term::Real(-2.0)})}}};
}

}  // namespace latchwork::lane_driver

// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/itinerary/itinerary_layer.h"

#include "latchwork/sdk/contract_body.h"

namespace latchwork::itinerary {
namespace {

using sdk::ArgumentSpec;
using sdk::ArgumentType;
using sdk::PortSpec;

const ArgumentSpec kLandmark{"landmark", ArgumentType::kSymbol, ""};
const ArgumentSpec kElevator{"elevator", ArgumentType::kSymbol, ""};
const ArgumentSpec kFloor{"floor", ArgumentType::kInteger, ""};

std::vector<PortSpec> Inputs() {
  PortSpec place{.name = "place",
                 .predicates = {{"curr_landmark", {kLandmark}, "the last landmark reached"}},
                 .help = "where the robot is"};
  PortSpec building{
      .name = "building",
      .predicates = {{"adjacent", {kLandmark, kLandmark}, "a straight free way"},
                     {"elevator_front", {kElevator, kLandmark, kFloor}, "before its door"},
                     {"cab", {kElevator, kLandmark}, "in its cab"}},
      .help = "what does not change"};
  PortSpec doors{.name = "doors",
                 .predicates = {{"door_shut", {kLandmark}, "no way through its middle"}},
                 .help = "doors that are shut",
                 .optional = true};
  PortSpec goal{.name = "goal",
                .predicates = {{"goal", {kLandmark}, "where the user wants the robot"}},
                .help = "the user's wish; silent: nowhere"};
  PortSpec elevators{
      .name = "elevators",
      .predicates = {{"elevator_at", {kElevator, kFloor}, "where the cab is"},
                     {"elevator_out_of_order", {kElevator}, "it takes nobody anywhere"}},
      .help = "how the elevators are",
      .optional = true};
  return {std::move(place), std::move(building), std::move(doors), std::move(goal),
          std::move(elevators)};
}

sdk::Contract MakeContract() {
  PortSpec next{.name = "next",
                .predicates = {{"target_landmark", {kLandmark}, "be there next"}},
                .help = "the first step of the plan, for layer 2"};
  return {Inputs(), {std::move(next)}};
}

}  // namespace

const sdk::Contract& ItineraryLayer::contract() const {
  static const sdk::Contract contract = MakeContract();
  return contract;
}

std::span<const sdk::ParameterSpec> ItineraryLayer::parameters() const { return {}; }

sdk::Body ItineraryLayer::MakeBody(std::string_view language, const sdk::Parameters& /*parameters*/,
                                   const std::filesystem::path& data,
                                   logic::SymbolTable& symbols) const {
  sdk::Body body = sdk::ContractBody(contract(), language, symbols);
  body.files = {data / (language == "icarus" ? "itinerary.icarus" : "itinerary.p")};
  body.minimized = {{{symbols.Intern("goal"), 1}, 0},
                    {{symbols.Intern("door_shut"), 1}, 0},
                    {{symbols.Intern("elevator_out_of_order"), 1}, 0}};
  return body;
}

}  // namespace latchwork::itinerary

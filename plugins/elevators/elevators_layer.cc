// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/elevators/elevators_layer.h"

#include <memory>

#include "latchwork/sdk/contract_body.h"
#include "plugins/elevators/shortest_plan.h"

namespace latchwork::elevators {
namespace {

using sdk::ArgumentSpec;
using sdk::ArgumentType;
using sdk::PortSpec;

constexpr std::int64_t kLongestPlan = 4;  // as many as elevators.p has shapes

const ArgumentSpec kLandmark{"landmark", ArgumentType::kSymbol, ""};
const ArgumentSpec kElevator{"elevator", ArgumentType::kSymbol, ""};
const ArgumentSpec kFloor{"floor", ArgumentType::kInteger, ""};
const ArgumentSpec kX{"x", ArgumentType::kReal, "m"};
const ArgumentSpec kY{"y", ArgumentType::kReal, "m"};

PortSpec PlacePort() {
  return {.name = "place",
          .predicates = {{"curr_landmark", {kLandmark}, "the last landmark reached"}},
          .help = "where the robot is"};
}

PortSpec ElevatorsPort() {
  return {.name = "elevators",
          .predicates = {{"elevator_at", {kElevator, kFloor}, "where the cab is"},
                         {"elevator_open", {kElevator}, "its door is open, where it is"},
                         {"elevator_out_of_order", {kElevator}, "it takes nobody anywhere"},
                         {"inside", {kElevator}, "the robot is in its cab"}},
          .help = "how the elevators are"};
}

PortSpec BuildingPort() {
  return {.name = "building",
          .predicates = {{"landmark", {kLandmark, kFloor, kX, kY}, "a named place"},
                         {"adjacent", {kLandmark, kLandmark}, "a straight free way"},
                         {"elevator", {kElevator}, "an elevator"},
                         {"elevator_front", {kElevator, kLandmark, kFloor}, "before its door"},
                         {"cab", {kElevator, kLandmark}, "in its cab"}},
          .help = "what does not change"};
}

PortSpec TargetPort() {
  return {.name = "target",
          .predicates = {{"target_landmark", {kLandmark}, "be there next"}},
          .help = "the next landmark, from above"};
}

sdk::Contract MakeContract() {
  PortSpec destination{.name = "destination",
                       .predicates = {{"move_cmd", {kX, kY}, "go there on foot"}},
                       .help = "where to go now, for layer 1"};
  PortSpec buttons{.name = "buttons",
                   .predicates = {{"call", {kElevator, kFloor}, "the button on a floor"},
                                  {"ride", {kElevator, kFloor}, "the button in the cab"}},
                   .help = "what to press now"};
  return {{PlacePort(), ElevatorsPort(), BuildingPort(), TargetPort()},
          {std::move(destination), std::move(buttons)}};
}

}  // namespace

const sdk::Contract& ElevatorsLayer::contract() const {
  static const sdk::Contract contract = MakeContract();
  return contract;
}

std::span<const sdk::ParameterSpec> ElevatorsLayer::parameters() const { return {}; }

sdk::Body ElevatorsLayer::MakeBody(std::string_view language, const sdk::Parameters& /*parameters*/,
                                   const std::filesystem::path& data,
                                   logic::SymbolTable& symbols) const {
  sdk::Body body = sdk::ContractBody(contract(), language, symbols);
  body.files = {data / (language == "icarus" ? "elevators.icarus" : "elevators.p")};
  body.minimized = {{{symbols.Intern("target_landmark"), 1}, 0},
                    {{symbols.Intern("elevator_open"), 1}, 0},
                    {{symbols.Intern("elevator_out_of_order"), 1}, 0},
                    {{symbols.Intern("inside"), 1}, 0},
                    {{symbols.Intern("same_elevator"), 2}, 0}};
  body.attachments = {std::make_shared<ShortestPlan>(kLongestPlan, symbols)};
  return body;
}

}  // namespace latchwork::elevators

// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/avoid/avoid_layer.h"

#include <memory>
#include <numbers>

#include "latchwork/sdk/contract_body.h"
#include "latchwork/sdk/specs.h"
#include "plugins/avoid/get_clearance.h"
#include "plugins/avoid/get_force.h"

namespace latchwork::avoid {
namespace {

using sdk::ArgumentType;
using sdk::ParameterSpec;
using sdk::PortSpec;
using sdk::RealParameter;

const sdk::ArgumentSpec kSonar{"sonar", ArgumentType::kInteger, ""};
const sdk::ArgumentSpec kObject{"object", ArgumentType::kAny, ""};
const sdk::ArgumentSpec kAngle{"angle", ArgumentType::kReal, "rad"};

sdk::ArgumentSpec Metres(std::string name) { return {std::move(name), ArgumentType::kReal, "m"}; }

PortSpec SonarPort() {
  return {.name = "sonar",
          .predicates = {{"sonar_reading", {kSonar, Metres("gap")}, "an echo, from the hull"},
                         {"no_echo", {kSonar}, "nothing heard within range"}},
          .help = "the sonar ring, every tick"};
}

PortSpec RobotPort() {
  return {.name = "robot",
          .predicates = {{"sonar_direction", {kSonar, kAngle}, "where a sonar looks"},
                         {"robot_radius", {Metres("radius")}, "of the hull"}},
          .help = "what the robot is like"};
}

PortSpec ObjectsPort() {
  return {.name = "objects",
          .predicates = {{"object", {kObject}, "there is such an object"},
                         {"distance", {kObject, Metres("distance")}, "from the robot's centre"},
                         {"direction", {kObject, kAngle}, "relative to the heading"}},
          .help = "virtual objects that push the robot",
          .optional = true};
}

PortSpec MotionPort() {
  return {.name = "motion",
          .predicates = {{"fwd", {{"speed", ArgumentType::kReal, "m/s"}}, "go forward"},
                         {"turn", {kAngle}, "turn from the present heading"},
                         {"halt", {}, "brake; wins over fwd"}},
          .help = "what the wheels are told",
          .uninhibitable = true};
}

std::vector<ParameterSpec> MakeParameters() {
  constexpr double kPi = std::numbers::pi;
  return {
      RealParameter("sense_range", "2.5", 0.1, 100, "m", "echoes from a larger gap are no objects"),
      RealParameter("halt_gap", "0.15", 0, 10, "m",
                    "an object ahead within this gap from the hull halts"),
      RealParameter("halt_half_angle", "0.5", 0, kPi, "rad",
                    "ahead is within this angle of the heading"),
      RealParameter("influence", "0.8", 0.05, 100, "m", "gap within which a sensed object repels"),
      RealParameter("repulsion", "0.12", 0, 100, "",
                    "strength of a sensed object at half the influence"),
      RealParameter("circulation", "1.0", 0, 10, "",
                    "share of the repulsion that leads round an object"),
      RealParameter("push", "1.0", 0, 100, "", "strength of a virtual object at 1 m"),
      RealParameter("cone_half_angle", "0.2181662", 0, kPi, "rad",
                    "half the opening of a sonar cone"),
      RealParameter("margin", "0.1", 0, 10, "m",
                    "gap that is left to what stands beside the way ahead"),
      RealParameter("horizon", "3.0", 0.1, 100, "m", "the way ahead is not looked at beyond this"),
      RealParameter("least_force", "0.05", 0, 100, "", "a weaker force does not move the robot"),
      RealParameter("turn_tolerance", "0.05", 0.001, kPi, "rad",
                    "a smaller heading error is let be"),
      RealParameter("aligned_within", "0.9", 0.01, kPi, "rad",
                    "no step forward at a larger heading error"),
      RealParameter("speed_gain", "0.6", 0, 100, "m/s", "speed for a force of strength 1"),
      RealParameter("max_speed", "0.6", 0, 10, "m/s", "never faster"),
      RealParameter("headway", "0.7", 0.1, 100, "s", "time in which the way ahead may be used up"),
  };
}

ForceLaw LawOf(const sdk::Parameters& parameters) {
  return {.influence = parameters.Real("influence"),
          .repulsion = parameters.Real("repulsion"),
          .circulation = parameters.Real("circulation"),
          .push = parameters.Real("push")};
}

}  // namespace

const sdk::Contract& AvoidLayer::contract() const {
  static const sdk::Contract contract{{SonarPort(), RobotPort(), ObjectsPort()}, {MotionPort()}};
  return contract;
}

std::span<const ParameterSpec> AvoidLayer::parameters() const {
  static const std::vector<ParameterSpec> parameters = MakeParameters();
  return parameters;
}

sdk::Body AvoidLayer::MakeBody(std::string_view language, const sdk::Parameters& parameters,
                               const std::filesystem::path& data,
                               logic::SymbolTable& symbols) const {
  sdk::Body body = sdk::ContractBody(contract(), language, symbols);
  body.files = {data / (language == "icarus" ? "avoid.icarus" : "avoid.p")};
  body.facts = sdk::ParameterFacts(parameters, symbols);
  body.minimized = {{{symbols.Intern("halt_robot"), 0}, 0},
                    {{symbols.Intern("object"), 1}, 0},
                    {{symbols.Intern("distance"), 2}, 0},
                    {{symbols.Intern("direction"), 2}, 0}};
  body.attachments = {std::make_shared<GetForce>(LawOf(parameters), symbols),
                      std::make_shared<GetClearance>(
                          ClearanceOptions{.margin = parameters.Real("margin"),
                                           .half_cone = parameters.Real("cone_half_angle"),
                                           .horizon = parameters.Real("horizon")},
                          symbols)};
  return body;
}

std::vector<sdk::Fallback> AvoidLayer::fallbacks(logic::SymbolTable& symbols) const {
  return {{.port = 0, .facts = {logic::Fact(symbols.Intern("halt"))}}};
}

}  // namespace latchwork::avoid

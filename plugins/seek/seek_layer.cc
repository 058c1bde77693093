// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/seek/seek_layer.h"

#include <memory>
#include <numbers>

#include "latchwork/sdk/contract_body.h"
#include "latchwork/sdk/specs.h"
#include "plugins/seek/bearing.h"

namespace latchwork::seek {
namespace {

using sdk::ArgumentSpec;
using sdk::ArgumentType;
using sdk::ParameterSpec;
using sdk::PortSpec;

const ArgumentSpec kX{"x", ArgumentType::kReal, "m"};
const ArgumentSpec kY{"y", ArgumentType::kReal, "m"};
const ArgumentSpec kAngle{"angle", ArgumentType::kReal, "rad"};
const ArgumentSpec kFloor{"floor", ArgumentType::kInteger, ""};
const ArgumentSpec kObject{"object", ArgumentType::kAny, ""};

sdk::Contract MakeContract() {
  PortSpec pose{.name = "pose",
                .predicates = {{"curr_location", {kX, kY}, "in the building's frame"},
                               {"curr_heading", {kAngle}, "counter-clockwise from the x axis"},
                               {"curr_floor", {kFloor}, "for reasoners that use a map"}},
                .help = "where the robot is"};
  PortSpec destination{.name = "destination",
                       .predicates = {{"move_cmd", {kX, kY}, "go there"}},
                       .help = "where to go, from above; silent: nowhere"};
  PortSpec push{
      .name = "push",
      .predicates = {{"object", {kObject}, "the pushing object"},
                     {"distance", {kObject, {"distance", ArgumentType::kReal, "m"}}, "to it"},
                     {"direction", {kObject, kAngle}, "opposite the destination's sector"}},
      .help = "a virtual object for layer 0"};
  return {{std::move(pose), std::move(destination)}, {std::move(push)}};
}

std::vector<ParameterSpec> MakeParameters() {
  return {sdk::IntegerParameter("sectors", "8", 4, 360,
                                "directions that the push is rounded to, relative to the heading"),
          sdk::RealParameter("arrive_tolerance", "0.2", 0.01, 10, "m",
                             "nearer than this the destination is reached and nothing pushes"),
          sdk::RealParameter("push_distance", "1.0", 0.1, 100, "m",
                             "of the pushing object behind the robot; the farther, the weaker")};
}

}  // namespace

const sdk::Contract& SeekLayer::contract() const {
  static const sdk::Contract contract = MakeContract();
  return contract;
}

std::span<const ParameterSpec> SeekLayer::parameters() const {
  static const std::vector<ParameterSpec> parameters = MakeParameters();
  return parameters;
}

sdk::Body SeekLayer::MakeBody(std::string_view language, const sdk::Parameters& parameters,
                              const std::filesystem::path& data,
                              logic::SymbolTable& symbols) const {
  sdk::Body body = sdk::ContractBody(contract(), language, symbols);
  body.files = {data / (language == "icarus" ? "seek.icarus" : "seek.p")};
  body.facts = sdk::ParameterFacts(parameters, symbols);
  const double width = 2.0 * std::numbers::pi / static_cast<double>(parameters.Integer("sectors"));
  body.facts.emplace_back(symbols.Intern("sector_width"),
                          std::initializer_list<logic::Term>{logic::Term::Real(width)});
  body.minimized = {{{symbols.Intern("move_cmd"), 2}, 0}};
  body.attachments = {std::make_shared<Bearing>()};
  return body;
}

}  // namespace latchwork::seek

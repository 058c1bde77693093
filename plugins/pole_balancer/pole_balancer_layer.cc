// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/pole_balancer/pole_balancer_layer.h"

#include <utility>

#include "latchwork/sdk/contract_body.h"
#include "latchwork/sdk/specs.h"

namespace latchwork::pole_balancer {
namespace {

using sdk::ArgumentType;
using sdk::ParameterSpec;
using sdk::PredicateSpec;
using sdk::RealParameter;

PredicateSpec Reading(std::string name, std::string argument, std::string unit, std::string help) {
  return {std::move(name),
          {{std::move(argument), ArgumentType::kReal, std::move(unit)}},
          std::move(help)};
}

sdk::Contract MakeContract() {
  return {{{.name = "motion",
            .predicates = {Reading("pole_angle", "angle", "rad", "from upright, to the right > 0"),
                           Reading("pole_rate", "rate", "rad/s", "of the angle"),
                           Reading("cart_place", "place", "m", "from the middle, right > 0"),
                           Reading("cart_speed", "speed", "m/s", "to the right > 0")},
            .help = "cart and pole"}},
          {{.name = "motor",
            .predicates = {Reading("force", "force", "N", "on the cart, to the right > 0")},
            .help = "of the cart"}}};
}

}  // namespace

const sdk::Contract& PoleBalancerLayer::contract() const {
  static const sdk::Contract contract = MakeContract();
  return contract;
}

std::span<const ParameterSpec> PoleBalancerLayer::parameters() const {
  static const std::vector<ParameterSpec> parameters = {
      RealParameter("safe_lean", "0.16", 0.001, 1, "rad",
                    "beyond it, as foreseen, catching the pole is all that matters"),
      RealParameter("middle", "0.1", 0.001, 10, "m",
                    "so near, as foreseen, the cart is in the middle"),
      RealParameter("greatest_lean", "0.12", 0.001, 0.5, "rad",
                    "that brings the cart back to the middle"),
      RealParameter("stiffness", "45", 1, 1000, "N/rad", "force for each rad that the pole is off"),
  };
  return parameters;
}

sdk::Body PoleBalancerLayer::MakeBody(std::string_view language, const sdk::Parameters& parameters,
                                      const std::filesystem::path& data,
                                      logic::SymbolTable& symbols) const {
  sdk::Body body = sdk::ContractBody(contract(), language, symbols);
  body.files = {data / "pole_balancer.icarus"};
  body.facts = sdk::ParameterFacts(parameters, symbols);
  return body;
}

}  // namespace latchwork::pole_balancer

// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cart_pole/cart_pole_contract.h"

#include <string>
#include <utility>

namespace latchwork::cart_pole {

namespace {

using sdk::ArgumentSpec;
using sdk::ArgumentType;
using sdk::ParameterSpec;
using sdk::ParameterType;

ArgumentSpec Real(std::string name, std::string unit) {
  return {std::move(name), ArgumentType::kReal, std::move(unit)};
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

}  // namespace

sdk::Contract CartPoleContract() {
  return {{{"motor",
            {{"force", {Real("force", "N")}, "on the cart, to the right > 0; up to force_limit"}},
            "drives the cart; nothing: it rolls",
            true}},
          {{"motion",
            {{"pole_angle", {Real("angle", "rad")}, "from upright, leaning to the right > 0"},
             {"pole_rate", {Real("rate", "rad/s")}, "of the angle"},
             {"cart_place", {Real("place", "m")}, "from the middle of the track, right > 0"},
             {"cart_speed", {Real("speed", "m/s")}, "to the right > 0"}},
            "with noise; every tick"},
           {"track",
            {{"track_end", {Real("place", "m")}, "to either side of the middle"},
             {"force_limit", {Real("force", "N")}, "of the motor"}},
            "what does not change; at tick 0"}}};
}

std::vector<sdk::PredicateSpec> CartPoleEvents() {
  return {{"push_cart", {Real("blow", "N s")}, "somebody pushes the cart, to the right > 0"},
          {"push_pole", {Real("blow", "N s")}, "somebody pushes the pole at its tip"}};
}

std::vector<ParameterSpec> CartPoleParameters() {
  return {
      Number("keep_for", "60", 0.1, 100000, "s", "the run is won when the pole stood for so long"),
      Number("fallen", "0.5", 0.05, 1.5, "rad", "an angle at which the pole counts as fallen"),
      Number("track_end", "2.4", 0.2, 1000, "m", "to either side of the middle"),
      Number("force_limit", "10", 0.1, 1000, "N", "of the motor"),
      Number("start_angle", "0.15", 0, 0.5, "rad", "it starts at random in plus or minus this"),
      Number("start_rate", "0.3", 0, 5, "rad/s", "likewise"),
      Number("start_place", "1", 0, 1000, "m", "likewise"),
      Number("start_speed", "0.3", 0, 5, "m/s", "likewise"),
      Number("pushes", "6", 0, 600, "1/min", "blows against the tip of the pole at random times"),
      Number("push_strength", "0.04", 0, 1, "N s", "the hardest of them, to either side"),
      Number("angle_noise", "0.003", 0, 1, "rad", "standard deviation of pole_angle"),
      Number("rate_noise", "0.03", 0, 5, "rad/s", "of pole_rate"),
      Number("place_noise", "0.003", 0, 1, "m", "of cart_place"),
      Number("speed_noise", "0.02", 0, 5, "m/s", "of cart_speed"),
      Number("cart_mass", "1", 0.01, 1000, "kg", ""),
      Number("pole_mass", "0.1", 0.001, 100, "kg", "a uniform rod"),
      Number("pole_length", "1", 0.05, 100, "m", ""),
      Number("cart_friction", "0.1", 0, 100, "N s/m", "of the wheels"),
      Number("pivot_friction", "0.0001", 0, 1, "N m s/rad", "of the pivot"),
  };
}

}  // namespace latchwork::cart_pole

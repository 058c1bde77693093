// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/cart_pole/cart_pole_contract.h"

#include <string>
#include <utility>

#include "latchwork/sdk/specs.h"

namespace latchwork::cart_pole {

namespace {

using sdk::ParameterSpec;
using sdk::RealArgument;
using sdk::RealParameter;

}  // namespace

sdk::Contract CartPoleContract() {
  return {
      {{"motor",
        {{"force",
          {RealArgument("force", "N")},
          "on the cart, to the right > 0; up to force_limit"}},
        "drives the cart; nothing: it rolls",
        true}},
      {{"motion",
        {{"pole_angle", {RealArgument("angle", "rad")}, "from upright, leaning to the right > 0"},
         {"pole_rate", {RealArgument("rate", "rad/s")}, "of the angle"},
         {"cart_place", {RealArgument("place", "m")}, "from the middle of the track, right > 0"},
         {"cart_speed", {RealArgument("speed", "m/s")}, "to the right > 0"}},
        "with noise; every tick"},
       {"track",
        {{"track_end", {RealArgument("place", "m")}, "to either side of the middle"},
         {"force_limit", {RealArgument("force", "N")}, "of the motor"}},
        "what does not change; at tick 0"}}};
}

std::vector<sdk::PredicateSpec> CartPoleEvents() {
  return {
      {"push_cart", {RealArgument("blow", "N s")}, "somebody pushes the cart, to the right > 0"},
      {"push_pole", {RealArgument("blow", "N s")}, "somebody pushes the pole at its tip"}};
}

std::vector<ParameterSpec> CartPoleParameters() {
  return {
      RealParameter("keep_for", "60", 0.1, 100000, "s",
                    "the run is won when the pole stood for so long"),
      RealParameter("fallen", "0.5", 0.05, 1.5, "rad",
                    "an angle at which the pole counts as fallen"),
      RealParameter("track_end", "2.4", 0.2, 1000, "m", "to either side of the middle"),
      RealParameter("force_limit", "10", 0.1, 1000, "N", "of the motor"),
      RealParameter("start_angle", "0.15", 0, 0.5, "rad",
                    "it starts at random in plus or minus this"),
      RealParameter("start_rate", "0.3", 0, 5, "rad/s", "likewise"),
      RealParameter("start_place", "1", 0, 1000, "m", "likewise"),
      RealParameter("start_speed", "0.3", 0, 5, "m/s", "likewise"),
      RealParameter("pushes", "6", 0, 600, "1/min",
                    "blows against the tip of the pole at random times"),
      RealParameter("push_strength", "0.04", 0, 1, "N s", "the hardest of them, to either side"),
      RealParameter("angle_noise", "0.003", 0, 1, "rad", "standard deviation of pole_angle"),
      RealParameter("rate_noise", "0.03", 0, 5, "rad/s", "of pole_rate"),
      RealParameter("place_noise", "0.003", 0, 1, "m", "of cart_place"),
      RealParameter("speed_noise", "0.02", 0, 5, "m/s", "of cart_speed"),
      RealParameter("cart_mass", "1", 0.01, 1000, "kg", ""),
      RealParameter("pole_mass", "0.1", 0.001, 100, "kg", "a uniform rod"),
      RealParameter("pole_length", "1", 0.05, 100, "m", ""),
      RealParameter("cart_friction", "0.1", 0, 100, "N s/m", "of the wheels"),
      RealParameter("pivot_friction", "0.0001", 0, 1, "N m s/rad", "of the pivot"),
  };
}

}  // namespace latchwork::cart_pole

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_POLE_BALANCER_POLE_BALANCER_LAYER_H_
#define LATCHWORK_PLUGINS_POLE_BALANCER_POLE_BALANCER_LAYER_H_

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/layer.h"

namespace latchwork::pole_balancer {

/// Balances a pole on a cart. Inputs: `motion` and `track` from the world. Output: `motor`. Its
/// objectives are processes that are kept up, not states that are reached. Source: Shapiro and
/// Langley (Agents'99), section 4, "processes as objectives".
class PoleBalancerLayer final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override;
  std::span<const sdk::ParameterSpec> parameters() const override;
  std::vector<std::string> languages() const override { return {"icarus"}; }
  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data, logic::SymbolTable& symbols) const override;
};

}  // namespace latchwork::pole_balancer

#endif  // LATCHWORK_PLUGINS_POLE_BALANCER_POLE_BALANCER_LAYER_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_LANE_DRIVER_LANE_DRIVER_LAYER_H_
#define LATCHWORK_PLUGINS_LANE_DRIVER_LANE_DRIVER_LAYER_H_

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/layer.h"

namespace latchwork::lane_driver {

/// Drives a car on a road of several lanes. Inputs: `self`, `cars`, `road` and, for reasoners that
/// learn, `reward`, all from the world. Output: `drive`, pedals and steering. Source: Shapiro and
/// Langley (Agents'99), section 5, "a vehicle in a traffic simulation", and table 8.
class LaneDriverLayer final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override;
  std::span<const sdk::ParameterSpec> parameters() const override;
  std::vector<std::string> languages() const override { return {"icarus"}; }
  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data, logic::SymbolTable& symbols) const override;
  std::vector<sdk::Fallback> fallbacks(logic::SymbolTable& symbols) const override;
};

}  // namespace latchwork::lane_driver

#endif  // LATCHWORK_PLUGINS_LANE_DRIVER_LANE_DRIVER_LAYER_H_

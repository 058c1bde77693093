// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_BUMPER_DRIVER_BUMPER_DRIVER_LAYER_H_
#define LATCHWORK_PLUGINS_BUMPER_DRIVER_BUMPER_DRIVER_LAYER_H_

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/layer.h"

namespace latchwork::bumper_driver {

/// Drives a bumper car after the programs of Shapiro and Langley (Agents'99, tables 1 and 5 to 10).
/// Inputs: the sensors of the arena. Outputs: pedal and wheel, and what is done at the gate.
class BumperDriverLayer final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override;
  std::span<const sdk::ParameterSpec> parameters() const override;
  std::vector<std::string> languages() const override { return {"icarus"}; }
  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data, logic::SymbolTable& symbols) const override;
};

}  // namespace latchwork::bumper_driver

#endif  // LATCHWORK_PLUGINS_BUMPER_DRIVER_BUMPER_DRIVER_LAYER_H_

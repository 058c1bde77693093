// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_CLEANER_CLEANER_LAYER_H_
#define LATCHWORK_PLUGINS_CLEANER_CLEANER_LAYER_H_

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/layer.h"

namespace latchwork::cleaner {

/// Cleans a floor of tiles, recharges in time, and goes home when nothing is left to clean. Inputs:
/// what a robot of the world `cleaning` senses. Output: `motion`, for its wheels.
class CleanerLayer final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override;
  std::span<const sdk::ParameterSpec> parameters() const override;
  std::vector<std::string> languages() const override { return {"icarus"}; }
  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data, logic::SymbolTable& symbols) const override;
};

}  // namespace latchwork::cleaner

#endif  // LATCHWORK_PLUGINS_CLEANER_CLEANER_LAYER_H_

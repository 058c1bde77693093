// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_GARDENER_GARDENER_LAYER_H_
#define LATCHWORK_PLUGINS_GARDENER_GARDENER_LAYER_H_

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/layer.h"

namespace latchwork::gardener {

/// Tends pumpkins through a season: shelters them from frost, waters the thirsty, feeds the hungry.
/// Inputs: what a gardener of the world `garden` senses. Output: `work`, what it does now.
class GardenerLayer final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override;
  std::span<const sdk::ParameterSpec> parameters() const override;
  std::vector<std::string> languages() const override { return {"icarus"}; }
  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data, logic::SymbolTable& symbols) const override;
};

}  // namespace latchwork::gardener

#endif  // LATCHWORK_PLUGINS_GARDENER_GARDENER_LAYER_H_

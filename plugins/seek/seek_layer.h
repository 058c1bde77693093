// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_SEEK_SEEK_LAYER_H_
#define LATCHWORK_PLUGINS_SEEK_SEEK_LAYER_H_

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/layer.h"

namespace latchwork::seek {

/// Layer 1, destination seeking. Inputs: `pose` from the world, `destination` from above. Output:
/// `push`, a virtual object that pushes the robot towards its destination, for layer 0. Without a
/// destination it is silent. Source: LSA (IJCAI-99), section 4.
class SeekLayer final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override;
  std::span<const sdk::ParameterSpec> parameters() const override;
  std::vector<std::string> languages() const override { return {"tptp", "icarus"}; }
  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data, logic::SymbolTable& symbols) const override;
};

}  // namespace latchwork::seek

#endif  // LATCHWORK_PLUGINS_SEEK_SEEK_LAYER_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_ELEVATORS_ELEVATORS_LAYER_H_
#define LATCHWORK_PLUGINS_ELEVATORS_ELEVATORS_LAYER_H_

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/layer.h"

namespace latchwork::elevators {

/// Layer 2, mid-level planning. Inputs: `place`, `elevators` and `building` from the world,
/// `target` from above. Outputs: `destination`, where to go in metres, and `buttons`, which buttons
/// to press. Source: LSA (IJCAI-99), section 4.
class ElevatorsLayer final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override;
  std::span<const sdk::ParameterSpec> parameters() const override;
  std::vector<std::string> languages() const override { return {"tptp", "icarus"}; }
  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data, logic::SymbolTable& symbols) const override;
};

}  // namespace latchwork::elevators

#endif  // LATCHWORK_PLUGINS_ELEVATORS_ELEVATORS_LAYER_H_

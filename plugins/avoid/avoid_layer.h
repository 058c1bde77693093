// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_AVOID_AVOID_LAYER_H_
#define LATCHWORK_PLUGINS_AVOID_AVOID_LAYER_H_

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/layer.h"

namespace latchwork::avoid {

/// Layer 0, obstacle avoidance. Inputs: `sonar` and `robot` from the world, `objects` from above.
/// Output: `motion`, which nothing may inhibit. Objects from above can push and can halt; none can
/// take a sensed object or a halt away. Source: LSA (IJCAI-99), section 4.
class AvoidLayer final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override;
  std::span<const sdk::ParameterSpec> parameters() const override;
  std::vector<std::string> languages() const override { return {"tptp", "icarus"}; }
  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data, logic::SymbolTable& symbols) const override;
  /// A robot whose reasoner fails stands still.
  std::vector<sdk::Fallback> fallbacks(logic::SymbolTable& symbols) const override;
};

}  // namespace latchwork::avoid

#endif  // LATCHWORK_PLUGINS_AVOID_AVOID_LAYER_H_

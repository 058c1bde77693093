// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_ITINERARY_ITINERARY_LAYER_H_
#define LATCHWORK_PLUGINS_ITINERARY_ITINERARY_LAYER_H_

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/layer.h"

namespace latchwork::itinerary {

/// Layer 3, high-level planning. Inputs: `place`, `building`, `doors`, `goal` and, where the world
/// has them, `elevators`. Output: `next`, the first landmark on the shortest way to the goal.
/// Source: LSA (IJCAI-99), section 4.
class ItineraryLayer final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override;
  std::span<const sdk::ParameterSpec> parameters() const override;
  std::vector<std::string> languages() const override { return {"tptp", "icarus"}; }
  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data, logic::SymbolTable& symbols) const override;
};

}  // namespace latchwork::itinerary

#endif  // LATCHWORK_PLUGINS_ITINERARY_ITINERARY_LAYER_H_

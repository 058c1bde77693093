// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_HANOI_PLAYER_HANOI_PLAYER_LAYER_H_
#define LATCHWORK_PLUGINS_HANOI_PLAYER_HANOI_PLAYER_LAYER_H_

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/layer.h"

namespace latchwork::hanoi_player {

/// Plays the Tower of Hanoi with a gripper: looks at the position in every cycle and goes on from
/// there. Inputs: what the world's sensors say. Output: what the gripper does next.
class HanoiPlayerLayer final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override;
  std::span<const sdk::ParameterSpec> parameters() const override { return {}; }
  std::vector<std::string> languages() const override { return {"icarus"}; }
  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data, logic::SymbolTable& symbols) const override;
};

}  // namespace latchwork::hanoi_player

#endif  // LATCHWORK_PLUGINS_HANOI_PLAYER_HANOI_PLAYER_LAYER_H_

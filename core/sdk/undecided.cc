// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/undecided.h"

#include <algorithm>

namespace latchwork::sdk {

void Undecided::Clear() {
  facts.clear();
  states.clear();
}

void Undecided::Drop(std::span<const std::size_t> indices) {
  if (indices.empty()) return;
  const auto is_dropped = [&](std::size_t index) {
    return std::binary_search(indices.begin(), indices.end(), index);
  };
  std::size_t next = 0;
  std::erase_if(facts, [&](const logic::Fact&) { return is_dropped(next++); });
  for (GoalState& state : states) {
    std::erase_if(state, is_dropped);
    for (std::size_t& index : state) {
      index -= static_cast<std::size_t>(std::lower_bound(indices.begin(), indices.end(), index) -
                                        indices.begin());
    }
  }
  Unite(states);
  if (facts.empty()) states.clear();
}

void Unite(std::vector<GoalState>& states) {
  std::sort(states.begin(), states.end());
  states.erase(std::unique(states.begin(), states.end()), states.end());
}

}  // namespace latchwork::sdk

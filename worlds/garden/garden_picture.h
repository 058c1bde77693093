// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_GARDEN_GARDEN_PICTURE_H_
#define LATCHWORK_GARDEN_GARDEN_PICTURE_H_

#include <filesystem>
#include <vector>

#include "worlds/garden/garden_state.h"

namespace latchwork::garden {

/// Draws a season: `season.svg`, a still chart of weather, moisture, food and weights by bed;
/// `garden.svg`, in which the gardener walks and the pumpkins grow.
std::vector<std::filesystem::path> DrawGarden(const GardenState& state,
                                              const std::filesystem::path& folder);

}  // namespace latchwork::garden

#endif  // LATCHWORK_GARDEN_GARDEN_PICTURE_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CLEANING_CLEANING_PICTURE_H_
#define LATCHWORK_CLEANING_CLEANING_PICTURE_H_

#include <filesystem>
#include <vector>

#include "worlds/cleaning/cleaning_state.h"

namespace latchwork::cleaning {

/// Draws a run: `route.svg`, a still picture of the way, coloured by time, and of the dirt that is
/// left; `cleaning.svg`, in which the robot drives, the dirt goes and the battery empties.
std::vector<std::filesystem::path> DrawCleaning(const CleaningState& state,
                                                const std::filesystem::path& folder);

}  // namespace latchwork::cleaning

#endif  // LATCHWORK_CLEANING_CLEANING_PICTURE_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_BUMPER_DRIVER_SIGHT_H_
#define LATCHWORK_PLUGINS_BUMPER_DRIVER_SIGHT_H_

#include <memory>
#include <vector>

#include "latchwork/sdk/attachment.h"

namespace latchwork::bumper_driver {

/// What a driver knows of geometry, from a pose (X0, Y0, H), bearings relative to the heading,
/// counter-clockwise:
///   distance_to(X0, Y0, X, Y, Distance)
///   bearing_to(X0, Y0, H, X, Y, Bearing)
///   place_at(X0, Y0, H, Distance, Bearing, X, Y)
std::vector<std::shared_ptr<sdk::Attachment>> SightAttachments();

}  // namespace latchwork::bumper_driver

#endif  // LATCHWORK_PLUGINS_BUMPER_DRIVER_SIGHT_H_

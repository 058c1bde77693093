// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_CLEANER_ATTACHMENTS_H_
#define LATCHWORK_PLUGINS_CLEANER_ATTACHMENTS_H_

#include <memory>
#include <vector>

#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/attachment.h"

namespace latchwork::cleaner {

/// The geometry that the cleaner's program asks for: places and tiles, what a row of the floor
/// looks like after the present picture, and ways over the remembered floor. All are functions of
/// their arguments and of short-term memory.
///
///     tile_at(X, Y, Size, I, J)             the tile of a place, tiles having sides of Size m
///     bearing(X0, Y0, H, I, J, Size, D, B)  the middle of a tile as seen from a pose
///     row_after(J, Clean, Dirty)            row J, with the tiles in view as they are seen now
///     nearest_dirt(I, J, TI, TJ)            where to stand next in order to clean
///     way(I, J, TI, TJ, NI, NJ, Length)     how to get from tile to tile
std::vector<std::shared_ptr<sdk::Attachment>> MakeAttachments(logic::SymbolTable& symbols);

}  // namespace latchwork::cleaner

#endif  // LATCHWORK_PLUGINS_CLEANER_ATTACHMENTS_H_

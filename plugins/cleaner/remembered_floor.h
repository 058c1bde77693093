// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_CLEANER_REMEMBERED_FLOOR_H_
#define LATCHWORK_PLUGINS_CLEANER_REMEMBERED_FLOOR_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/attachment.h"

namespace latchwork::cleaner {

/// A tile of the floor: column and row.
struct Tile {
  int i = 0;
  int j = 0;
  friend bool operator==(const Tile&, const Tile&) = default;
};

/// Tiles are numbered from 0; memory holds nothing of those beyond.
inline constexpr int kMostTiles = 512;

enum class Memory : std::uint8_t { kUnknown, kClean, kDirty };

/// What short-term memory holds of the floor, by the facts clean_row(J, R), dirty_row(J, R) and
/// tried(I, J). R is `none` or runs(First, Last, First, Last, ...): in row J the tiles First to
/// Last are so. Tried: standing on that tile did not clean all around it. Thread rule: used by one
/// thread.
class RememberedFloor {
 public:
  explicit RememberedFloor(logic::SymbolTable& symbols);

  /// Reads memory as it is now.
  void Recall(sdk::AttachmentContext& context);

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t IndexOf(Tile tile) const {
    return static_cast<std::size_t>(tile.j) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(tile.i);
  }
  Memory At(Tile tile) const;
  bool WasTried(Tile tile) const;
  /// Whether a robot that is wider than a tile, but not than two, can stand in its middle: the tile
  /// and the eight around it are floor.
  bool IsOpen(Tile tile) const;
  /// Whether one of the nine tiles around this one, or itself, is dirty.
  bool HasDirtAround(Tile tile) const;

 private:
  void Resize();
  void Fill(std::span<const logic::Term> row, Memory memory);

  std::vector<logic::Literal> clean_query_;
  std::vector<logic::Literal> dirty_query_;
  std::vector<logic::Literal> tried_query_;
  std::vector<logic::Term> clean_;  ///< Pairs: row, runs.
  std::vector<logic::Term> dirty_;
  std::vector<Tile> tried_;
  int width_ = 0;
  int height_ = 0;
  std::vector<Memory> tiles_;
};

/// Calls `visit(first, last)` for every run of a row that is well formed.
template <typename Visit>
void ForRuns(const logic::Term& row, const Visit& visit) {
  const auto ends = row.arguments();
  for (std::size_t n = 0; n + 1 < ends.size(); n += 2) {
    if (ends[n].kind() != logic::Term::Kind::kInteger) return;
    if (ends[n + 1].kind() != logic::Term::Kind::kInteger) return;
    const std::int64_t first = ends[n].integer();
    const std::int64_t last = ends[n + 1].integer();
    if (first < 0 || last < first || last >= kMostTiles) return;
    visit(static_cast<int>(first), static_cast<int>(last));
  }
}

/// The answers to a query, appended term by term.
void Collect(sdk::AttachmentContext& context, std::span<const logic::Literal> query,
             std::size_t variables, std::vector<logic::Term>& answers);

/// A tile from two terms; nothing when they are no tile.
std::optional<Tile> TileOf(const logic::Term& i, const logic::Term& j);

}  // namespace latchwork::cleaner

#endif  // LATCHWORK_PLUGINS_CLEANER_REMEMBERED_FLOOR_H_

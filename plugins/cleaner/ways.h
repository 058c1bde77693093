// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_CLEANER_WAYS_H_
#define LATCHWORK_PLUGINS_CLEANER_WAYS_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "plugins/cleaner/remembered_floor.h"

namespace latchwork::cleaner {

/// Shortest ways of a robot over open tiles, from middle to middle in eight directions; it does not
/// cut corners. From a tile that is not open, the way leads to the nearest open one first, at most
/// two tiles away. Thread rule: used by one thread.
class Ways {
 public:
  struct Step {
    Tile next;          ///< As far as the way is straight.
    double length = 0;  ///< Of the whole way, in tiles.
  };

  /// The beginning of the way between two tiles; nothing when none is known.
  std::optional<Step> To(const RememberedFloor& floor, Tile from, Tile to);
  /// Where to stand next in order to clean: the nearest open tile with dirt around it that was not
  /// tried. `next` is that tile.
  std::optional<Step> ToDirt(const RememberedFloor& floor, Tile from);

 private:
  static constexpr int kUnmet = -1;

  void Begin(const RememberedFloor& floor);
  void Offer(const RememberedFloor& floor, Tile tile, int cost, std::size_t parent);
  void Spread(const RememberedFloor& floor, Tile tile, int cost);
  bool IsOpen(const RememberedFloor& floor, Tile tile);
  /// Visits tiles from near to far until `visit` says that it has seen enough.
  template <typename Visit>
  bool Flood(const RememberedFloor& floor, const Visit& visit);
  Step Straight(const RememberedFloor& floor, Tile from) const;

  std::vector<int> costs_;                ///< Of each tile; kUnmet.
  std::vector<std::size_t> parent_;       ///< The tile from which it was come to.
  std::vector<char> open_;                ///< 0 not looked at, 1 open, 2 not.
  std::vector<std::vector<Tile>> queue_;  ///< By cost, in turn.
  int latest_ = 0;
};

}  // namespace latchwork::cleaner

#endif  // LATCHWORK_PLUGINS_CLEANER_WAYS_H_

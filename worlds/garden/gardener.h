// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_GARDEN_GARDENER_H_
#define LATCHWORK_GARDEN_GARDENER_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "worlds/garden/bed.h"

namespace latchwork::garden {

/// Where a task is done: the well, or a bed by its number.
inline constexpr std::size_t kWell = static_cast<std::size_t>(-1);

struct Task {
  enum class Kind : std::uint8_t { kWalk, kFill, kPour, kFeed, kCover, kUncover };
  Kind kind = Kind::kWalk;
  std::size_t place = kWell;  ///< kWalk: where to.
  friend bool operator==(const Task&, const Task&) = default;
};

struct GardenerOptions {
  double speed = 0.25;       ///< m/s
  double tank = 40;          ///< l
  double portion = 10;       ///< g of food
  double bed_distance = 40;  ///< m, from the well to the first bed, and from bed to bed
};

/// Water that is collected at the well.
struct Barrel {
  double holds = 400;  ///< l
  double water = 400;  ///< l
  double spring = 10;  ///< l/h
};

/// The robot that works in the garden. A task takes time and goes on for as long as it is told; one
/// that is broken off has had its effect in part (water) or none (food, covers). Beds lie in a row
/// along a path that begins at the well.
class Gardener {
 public:
  Gardener(const GardenerOptions& options, int portions) : options_(options), portions_(portions) {}

  /// Works on a task for so many seconds; nothing: rests. A task that cannot be done here and now
  /// is no work.
  void Work(std::optional<Task> task, double seconds, std::vector<Bed>& beds, Barrel& barrel);

  /// Where it is: a bed or the well; nothing on the way between two of them.
  std::optional<std::size_t> place(std::size_t beds) const;
  double way() const { return way_; }      ///< m along the path, from the well
  double water() const { return water_; }  ///< l in its tank
  int portions() const { return portions_; }
  void AddPortions(int portions) { portions_ += portions; }
  double walked() const { return walked_; }  ///< m
  double poured() const { return poured_; }  ///< l
  const GardenerOptions& options() const { return options_; }
  double WayTo(std::size_t place) const;

 private:
  void Walk(std::size_t place, double seconds);
  void Pour(double seconds, Bed& bed);
  void Handle(const Task& task, double seconds, Bed& bed);

  GardenerOptions options_;
  double way_ = 0;
  double water_ = 0;
  int portions_ = 0;
  double walked_ = 0;
  double poured_ = 0;
  std::optional<Task> task_;
  double spent_ = 0;  ///< s on the present task
};

}  // namespace latchwork::garden

#endif  // LATCHWORK_GARDEN_GARDENER_H_

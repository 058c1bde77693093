// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_BUMPER_CARS_RIVAL_H_
#define LATCHWORK_BUMPER_CARS_RIVAL_H_

#include <cstddef>
#include <cstdint>

#include "latchwork/sdk/random.h"
#include "worlds/bumper_cars/arena.h"

namespace latchwork::bumper_cars {

/// Drives one of the other cars: from place to place, by seed; to a pole when its charge is used
/// up; backwards for a while where it is stuck. An enemy goes for the agent now and then, a friend
/// brakes for it.
class Rival {
 public:
  Rival(std::uint64_t seed, std::size_t car);

  Controls Decide(const Arena& arena, double seconds);

 private:
  void NextLeg(const Arena& arena);
  Vector Target(const Arena& arena) const;
  bool StartsBacking(const Car& car, double seconds);
  static Controls DriveTo(Vector target, double pedal, const Car& car);

  sdk::RandomStream random_;
  std::size_t car_;
  std::uint64_t leg_ = 0;
  double leg_left_ = 0;  // s
  Vector place_;
  bool hunts_ = false;
  double pedal_ = 0;
  double stuck_for_ = 0;
  double backing_left_ = 0;
};

}  // namespace latchwork::bumper_cars

#endif  // LATCHWORK_BUMPER_CARS_RIVAL_H_

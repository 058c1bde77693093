// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_HANOI_HAND_H_
#define LATCHWORK_HANOI_HAND_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "latchwork/sdk/random.h"
#include "worlds/hanoi/gripper.h"
#include "worlds/hanoi/pegs.h"

namespace latchwork::hanoi {

struct HandMove {
  int disk = 0;
  int peg = 0;

  friend bool operator==(const HandMove&, const HandMove&) = default;
};

/// Why a hand may not move the disk there; empty: it may. It keeps to the rules of the game, away
/// from a peg that the gripper is lowered onto and from what the gripper holds, and leaves that a
/// peg to go to.
std::string Objection(const HandMove& move, const Pegs& pegs, const Gripper& gripper);

/// All moves without an objection, in the order of disks and pegs.
std::vector<HandMove> LegalMoves(const Pegs& pegs, const Gripper& gripper);

/// A hand that moves disks from time to time, by seed.
class Hand {
 public:
  /// `every`: mean time between moves in s, 0: never.
  Hand(std::uint64_t seed, double every) : random_(seed, "hand"), every_(every), due_(Wait(0)) {}

  /// What it moves at this time, if anything.
  std::optional<HandMove> Step(double seconds, const Pegs& pegs, const Gripper& gripper);

 private:
  double Wait(std::uint64_t move) const { return every_ * random_.Between(0.5, 1.5, move, 0); }

  sdk::RandomStream random_;
  double every_;
  double due_;
  std::uint64_t moves_ = 0;
};

}  // namespace latchwork::hanoi

#endif  // LATCHWORK_HANOI_HAND_H_

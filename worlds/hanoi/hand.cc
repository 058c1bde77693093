// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/hanoi/hand.h"

#include <fmt/format.h>

namespace latchwork::hanoi {
namespace {

bool HasAPeg(int disk, const Pegs& pegs) {
  for (int peg = 0; peg < kPegs; ++peg) {
    if (pegs.Takes(peg, disk)) return true;
  }
  return false;
}

}  // namespace

std::string Objection(const HandMove& move, const Pegs& pegs, const Gripper& gripper) {
  if (move.disk < 1 || move.disk > pegs.disks())
    return fmt::format("there is no disk {}", move.disk);
  const int from = pegs.peg_of(move.disk);
  if (from == Pegs::kAir) return fmt::format("the gripper holds disk {}", move.disk);
  if (from == move.peg) return fmt::format("disk {} is there already", move.disk);
  if (pegs.Top(from) != move.disk) return fmt::format("a disk lies on disk {}", move.disk);
  if (!pegs.Takes(move.peg, move.disk)) return "the disk there is smaller";
  const auto above = gripper.above();
  if (!gripper.raised() && (above == from || above == move.peg)) return "the gripper is in the way";
  if (gripper.held() == 0) return {};
  Pegs after = pegs;
  after.Put(move.disk, move.peg);
  if (!HasAPeg(gripper.held(), after)) return "the disk in the gripper would find no peg";
  return {};
}

std::vector<HandMove> LegalMoves(const Pegs& pegs, const Gripper& gripper) {
  std::vector<HandMove> moves;
  for (int disk = 1; disk <= pegs.disks(); ++disk) {
    for (int peg = 0; peg < kPegs; ++peg) {
      const HandMove move{disk, peg};
      if (Objection(move, pegs, gripper).empty()) moves.push_back(move);
    }
  }
  return moves;
}

std::optional<HandMove> Hand::Step(double seconds, const Pegs& pegs, const Gripper& gripper) {
  if (every_ <= 0 || seconds < due_) return std::nullopt;
  ++moves_;
  due_ += Wait(moves_);
  const std::vector<HandMove> moves = LegalMoves(pegs, gripper);
  if (moves.empty()) return std::nullopt;
  return moves[random_.Index(moves.size(), moves_, 1)];
}

}  // namespace latchwork::hanoi

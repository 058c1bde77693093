// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/hanoi/pegs.h"

#include <algorithm>
#include <array>

namespace latchwork::hanoi {
namespace {

constexpr std::array<std::string_view, kPegs> kNames{"left", "middle", "right"};

}  // namespace

std::string_view PegName(int peg) { return kNames.at(static_cast<std::size_t>(peg)); }

std::optional<int> FindPeg(std::string_view name) {
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<int>(found - kNames.begin());
}

int Pegs::Top(int peg) const {
  const auto found = std::find(peg_of_.begin(), peg_of_.end(), peg);
  return found == peg_of_.end() ? 0 : static_cast<int>(found - peg_of_.begin()) + 1;
}

int Pegs::Count(int peg) const {
  return static_cast<int>(std::count(peg_of_.begin(), peg_of_.end(), peg));
}

int LeastMoves(const Pegs& pegs, int target) {
  int moves = 0;
  for (int disk = pegs.disks(); disk > 0; --disk) {
    const int peg = pegs.peg_of(disk);
    if (peg == target) continue;
    moves += 1 << (disk - 1);
    target = kPegs - peg - target;  // the third one, for all that are smaller
  }
  return moves;
}

}  // namespace latchwork::hanoi

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_HANOI_PEGS_H_
#define LATCHWORK_HANOI_PEGS_H_

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace latchwork::hanoi {

constexpr int kPegs = 3;
std::string_view PegName(int peg);
std::optional<int> FindPeg(std::string_view name);

/// Where the disks are: on a peg, or in the air. Disks are numbered by size, 1 is the smallest; on
/// a peg they lie in the order of their sizes, so no other position can be expressed.
class Pegs {
 public:
  static constexpr int kAir = -1;

  /// `peg_of`: the peg of disk 1, 2, ...
  explicit Pegs(std::vector<int> peg_of) : peg_of_(std::move(peg_of)) {}

  int disks() const { return static_cast<int>(peg_of_.size()); }
  int peg_of(int disk) const { return peg_of_[static_cast<std::size_t>(disk) - 1]; }
  /// The topmost disk; 0: none.
  int Top(int peg) const;
  int Count(int peg) const;
  /// Whether the disk may be put on the peg.
  bool Takes(int peg, int disk) const { return Top(peg) == 0 || Top(peg) > disk; }
  bool AllOn(int peg) const { return Count(peg) == disks(); }

  void Lift(int disk) { Place(disk, kAir); }
  void Put(int disk, int peg) { Place(disk, peg); }

  friend bool operator==(const Pegs&, const Pegs&) = default;

 private:
  void Place(int disk, int peg) { peg_of_[static_cast<std::size_t>(disk) - 1] = peg; }

  std::vector<int> peg_of_;
};

/// How many moves it takes at least to bring all disks onto `target`; none may be in the air.
/// From a given position the shortest way to a tower is unique: the largest disk that is elsewhere
/// has to move once, all smaller ones to the third peg before.
int LeastMoves(const Pegs& pegs, int target);

}  // namespace latchwork::hanoi

#endif  // LATCHWORK_HANOI_PEGS_H_

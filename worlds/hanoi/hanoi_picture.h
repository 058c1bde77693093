// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_HANOI_HANOI_PICTURE_H_
#define LATCHWORK_HANOI_HANOI_PICTURE_H_

#include <filesystem>
#include <string>
#include <vector>

#include "latchwork/sdk/svg.h"
#include "worlds/hanoi/gripper.h"
#include "worlds/hanoi/pegs.h"

namespace latchwork::hanoi {

/// What a run looked like.
struct Film {
  struct Remark {
    double seconds = 0;
    std::string text;
  };
  std::vector<sdk::SvgKeyframe> gripper;
  std::vector<std::vector<sdk::SvgKeyframe>> disks;  ///< By disk, from the smallest.
  std::vector<Remark> remarks;
  double seconds = 0;

  void Add(double seconds_now, const Pegs& pegs, const Gripper& gripper_now);
};

/// An animation, "hanoi.svg". False when the file cannot be written.
bool DrawFilm(const Film& film, int target, const std::filesystem::path& file);

}  // namespace latchwork::hanoi

#endif  // LATCHWORK_HANOI_HANOI_PICTURE_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_HANOI_GRIPPER_H_
#define LATCHWORK_HANOI_GRIPPER_H_

#include <optional>
#include <string>

#include "worlds/hanoi/pegs.h"

namespace latchwork::hanoi {

/// Sizes of the table, m.
constexpr double kPegDistance = 0.3;
constexpr double kThickness = 0.04;  // of a disk
double PegX(int peg);
/// How high the gripper, and the lower side of what it holds, is when it is raised.
double RaisedHeight(int disks);

struct GripperLimits {
  double travel_speed = 0.5;  ///< m/s, to the side.
  double lift_speed = 0.5;    ///< m/s, up and down.
  double grip_time = 0.3;     ///< s, to close and to open the fingers.
};

struct Command {
  enum class Kind : unsigned char { kNone, kMoveTo, kLower, kRaise, kGrasp, kRelease };
  Kind kind = Kind::kNone;
  int peg = 0;  ///< Of kMoveTo.

  friend bool operator==(const Command&, const Command&) = default;
};

/// A gripper on a rail above the pegs. It goes to the side while raised only, is lowered onto what
/// lies on the peg below it, and its fingers take their time. A command works as long as it is
/// given; what cannot be done is not done.
class Gripper {
 public:
  /// What a step led to, if anything.
  enum class Event : unsigned char { kNone, kGrasped, kSlipped, kReleased, kPutOnSmaller };

  Gripper(const GripperLimits& limits, int disks)
      : limits_(limits), x_(PegX(0)), z_(RaisedHeight(disks)), raised_z_(RaisedHeight(disks)) {}

  /// Moves on for `seconds`. `slips`: the fingers that now close find no hold.
  Event Step(const Command& command, double seconds, bool slips, Pegs& pegs);

  double x() const { return x_; }
  double z() const { return z_; }
  /// The disk that it holds; 0: none.
  int held() const { return held_; }
  bool raised() const { return z_ >= raised_z_; }
  /// The peg that it is right above.
  std::optional<int> above() const;
  /// Whether it, or the disk in it, stands on what is below.
  bool Down(const Pegs& pegs) const;
  /// What it has tried in vain, as a word for people: "moved to the side while lowered"; empty when
  /// the last command could be followed.
  const std::string& refusal() const { return refusal_; }

 private:
  double StopHeight(int peg, const Pegs& pegs) const;
  void MoveTo(int peg, double seconds);
  void Lower(double seconds, const Pegs& pegs);
  Event Close(double seconds, bool slips, Pegs& pegs);
  Event Open(double seconds, Pegs& pegs);

  GripperLimits limits_;
  double x_;
  double z_;
  double raised_z_;
  double fingers_ = 0;  // s that they have been closing or opening
  int held_ = 0;
  Command last_;
  std::string refusal_;
};

}  // namespace latchwork::hanoi

#endif  // LATCHWORK_HANOI_GRIPPER_H_

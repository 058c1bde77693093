// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_ROBOT_THEORY_H_
#define LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_ROBOT_THEORY_H_

#include <vector>

#include "reasoners/circumscription/theory/ground_theory.h"
#include "tests/reasoners/circumscription/random_theory.h"

namespace latchwork::circumscription {

/// A layer that avoids obstacles, ground. Per sonar an echo in one of three distance classes, which
/// is an object unless the sonar is abnormal; of a suspect sonar and its neighbour one is abnormal.
/// Per sector a push from above, which is a virtual object unless given up. What is near blocks its
/// sector, what is nearest ahead halts the robot. Abnormality is minimized first, then the rest;
/// where the robot may go varies. With 24 sonars: 258 atoms, 297 clauses.
struct RobotTheory {
  explicit RobotTheory(int sonars);

  /// Latches of one cycle: each sonar hears something with 40 %, each sector is pushed with 10 %.
  std::vector<Literal> Latches(Dice& dice, int suspect_percent) const;

  GroundTheory theory;
  std::vector<std::vector<Literal>> queries;  ///< 20, cautious.

 private:
  static constexpr int kSectors = 8;
  static constexpr int kClasses = 3;
  struct Sonar {
    Atom object, abnormal, suspect;
    Atom distance[kClasses], echo[kClasses];
  };
  struct Sector {
    Atom virtual_object, blocked, given_up, push, go;
  };

  void AddAtoms(int sonars);
  void AddSonar(std::size_t index);
  void AddSector(const Sector& sector);
  void AddQueries();

  std::vector<Sonar> sonars_;
  std::vector<Sector> sectors_;
  Atom ahead_ = 0;
  Atom halt_ = 0;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_ROBOT_THEORY_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_PEOPLE_H_
#define LATCHWORK_OFFICE_PEOPLE_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "latchwork/sdk/random.h"
#include "worlds/office/building.h"
#include "worlds/office/sonar.h"

namespace latchwork::office {

struct PeopleOptions {
  int count = 0;
  double speed = 0.8;   ///< m/s
  double radius = 0.2;  ///< m
  double distance =
      0.9;  ///< Nearer they do not come to the robot, or to people ahead, rim to rim, m.
  double patience = 4.0;  ///< s; then they turn round, or change sides.
};

/// People who walk up and down the corridors, on the right-hand side, by seed. They stop for each
/// other, and take no step that brings them nearer to a robot that is near. Thread rule: used by
/// one thread.
class People {
 public:
  /// Places nobody within 3 m of `keep_free`, the robot's place on floor `robot_floor`.
  People(const PeopleOptions& options, const Building& building, double tick_seconds,
         std::uint64_t seed, int robot_floor, Point keep_free);

  /// One tick. `maps` are the floors of this run, with what was put on them.
  void Step(std::uint64_t tick, std::span<const FloorMap> maps, int robot_floor, const Disc& robot);
  /// The people of a floor, as discs; the span lives until the next Step.
  std::span<const Disc> On(int floor) const { return discs_[static_cast<std::size_t>(floor)]; }
  std::size_t size() const { return people_.size(); }

 private:
  struct Person {
    int floor = 0;
    Point place;
    std::size_t from = 0;
    std::size_t to = 0;
    double speed = 0.0;
    int waited = 0;       ///< Ticks.
    double side = 1.0;    ///< Of the way: 1 right, -1 left.
    bool turned = false;  ///< Since the last step.
  };

  Point AimOf(const Person& person) const;
  bool IsBlocked(std::size_t self, Point next, const FloorMap& map, int robot_floor,
                 const Disc& robot) const;
  bool IsInTheWay(const Person& person, Point next, const Disc& other) const;
  /// Wherever the robot is: ahead, beside, or round a corner.
  bool ComesTooNear(const Person& person, Point next, const Disc& robot) const;
  std::size_t NextLandmark(const Person& person, std::uint64_t tick, std::size_t self) const;
  static void Turn(Person& person);
  void CollectDiscs();

  PeopleOptions options_;
  const Building* building_;
  double dt_;
  sdk::RandomStream random_;
  std::vector<std::vector<std::size_t>> ways_;  ///< By landmark: the corridor landmarks next to it.
  std::vector<Person> people_;
  std::vector<std::vector<Disc>> discs_;  ///< By floor.
};

/// By landmark: the neighbours that a corridor leads to; empty for landmarks in rooms, doors and
/// before elevators.
std::vector<std::vector<std::size_t>> CorridorWays(const Building& building);

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_PEOPLE_H_

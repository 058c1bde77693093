// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_PTTP_TOWER_H_
#define LATCHWORK_TESTS_REASONERS_PTTP_TOWER_H_

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::pttp {

/// What is asked of the actions of layer 2 (plugins/elevators/elevators.p): the whole plan.
inline constexpr std::string_view kPlanTo =
    "fof(plan_to, axiom, ![T, S] : ((target_landmark(T) & robot_at(T, S)) => plan_to(S))).";

/// A tower with sky lobbies: shaft i serves the floors from kFloors * i to kFloors * (i + 1), so
/// that every lobby has two. In each shaft are `bank` elevators. On each floor a corridor of
/// kPlaces landmarks leads from one shaft to the other. A trip takes four actions: every elevator
/// starts on a floor that is no lobby.
struct Tower {
  static constexpr int kFloors = 3;
  static constexpr int kPlaces = 4;

  /// As many trips as there is room for, the rest on foot.
  explicit Tower(int plan_length, int elevators_a_shaft = 1)
      : steps(plan_length), bank(elevators_a_shaft) {
    while (Length(shafts + 1, 0, 0) <= steps) ++shafts;
    const int walk = steps - Length(shafts, 0, 0);
    walk_in = walk / 2;
    walk_out = walk - walk_in;
  }

  static int Length(int trips, int in, int out) {
    return 4 * trips + (kPlaces - 1) * (trips - 1) + in + out;
  }
  static std::string Place(int floor, int place) { return fmt::format("l{}_{}", floor, place); }
  /// Shaft i is at the end of the corridors where its passengers do not come from.
  static int DoorOf(int shaft) { return shaft % 2 == 0 ? kPlaces - 1 : 0; }

  std::string Start() const { return walk_in == 0 ? Place(0, DoorOf(0)) : In(walk_in); }
  std::string Target() const {
    return walk_out == 0 ? Place(shafts * kFloors, DoorOf(shafts - 1)) : Out(walk_out);
  }

  std::vector<std::string> Building() const {
    std::vector<std::string> facts;
    const auto join = [&](const std::string& a, const std::string& b) {
      facts.push_back(fmt::format("adjacent({}, {})", a, b));
      facts.push_back(fmt::format("adjacent({}, {})", b, a));
    };
    for (int floor = 0; floor <= shafts * kFloors; ++floor) {
      for (int i = 1; i < kPlaces; ++i) join(Place(floor, i - 1), Place(floor, i));
    }
    for (int i = 0; i < elevators(); ++i) {
      const int shaft = i / bank;
      facts.push_back(fmt::format("elevator(e{})", i));
      facts.push_back(fmt::format("cab(e{}, c{})", i, i));
      for (int floor = shaft * kFloors; floor <= (shaft + 1) * kFloors; ++floor) {
        facts.push_back(
            fmt::format("elevator_front(e{}, {}, {})", i, Place(floor, DoorOf(shaft)), floor));
      }
    }
    for (int i = 1; i <= walk_in; ++i) {
      join(In(i), i == 1 ? Place(0, DoorOf(0)) : In(i - 1));
    }
    for (int i = 1; i <= walk_out; ++i) {
      join(Out(i), i == 1 ? Place(shafts * kFloors, DoorOf(shafts - 1)) : Out(i - 1));
    }
    return facts;
  }
  /// Where the elevators stand; it changes with the cycle.
  std::vector<std::string> Elevators(int cycle = 0) const {
    std::vector<std::string> facts;
    for (int i = 0; i < elevators(); ++i) {
      facts.push_back(
          fmt::format("elevator_at(e{}, {})", i, i / bank * kFloors + 1 + (i + cycle) % 2));
    }
    return facts;
  }
  int elevators() const { return shafts * bank; }

  int steps;
  int bank;
  int shafts = 1;
  int walk_in;
  int walk_out;

 private:
  static std::string In(int i) { return fmt::format("in{}", i); }
  static std::string Out(int i) { return fmt::format("out{}", i); }
};

/// Loads the domain of layer 2 with the question above.
inline void LoadElevators(AgentMind& mind, std::string_view goal = "plan_to(S)") {
  mind.body.files.emplace_back(std::string(LATCHWORK_SOURCE_DIR) +
                               "/plugins/elevators/elevators.p");
  for (const char* name : {"curr_landmark", "elevator", "target_landmark", "shortest_plan"}) {
    mind.Input(name, 1);
  }
  for (const char* name : {"elevator_at", "adjacent", "cab"}) mind.Input(name, 2);
  mind.Input("elevator_front", 3);
  mind.Input("landmark", 4);
  for (const char* name : {"elevator_open", "elevator_out_of_order", "inside"}) {
    mind.Input(name, 1);
    mind.Minimize(name, 1);
  }
  mind.Minimize("same_elevator", 2);
  mind.Goal(goal);
  mind.Load();
}

inline void EnterTower(AgentMind& mind, const Tower& tower) {
  mind.Latch(0, tower.Building());
  mind.Latch(1, tower.Elevators());
  mind.Latch(2, {"curr_landmark(" + tower.Start() + ")"});
  mind.Latch(3, {"target_landmark(" + tower.Target() + ")"});
}

}  // namespace latchwork::pttp

#endif  // LATCHWORK_TESTS_REASONERS_PTTP_TOWER_H_

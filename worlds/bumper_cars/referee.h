// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_BUMPER_CARS_REFEREE_H_
#define LATCHWORK_BUMPER_CARS_REFEREE_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/world.h"
#include "worlds/bumper_cars/arena.h"

namespace latchwork::bumper_cars {

/// What counts, and how much of it is asked for.
struct Rules {
  bool day = false;        ///< Pay, ride, leave; otherwise the cars are bumped.
  double ram_speed = 1.0;  ///< m/s, at least, into an enemy.
  double tap_speed = 0.8;  ///< m/s, at most, into a friend.
  int rams = 1;            ///< Different enemies.
  int taps = 0;            ///< Different friends.
  double ride_seconds = 90;
  int spills = 3;
  int thrills = 5;
};

/// Keeps the score of the agent and says how the run ends. Speeds are those with which the agent
/// itself drove at the other: being hit is nobody's merit or fault, nor is what one is pushed into
/// within half a second of it.
class Referee {
 public:
  enum class Park : std::uint8_t { kAtGate, kRiding, kOver, kOutside };

  Referee(const Rules& rules, std::size_t cars);

  /// The bumps of a tick, and what the agent is at the end of it.
  void Step(std::span<const Bump> bumps, const Arena& arena, double seconds);
  /// What the agent does at the gate in this tick; each takes its time.
  void Pay(double seconds);
  void Leave(const Arena& arena, double seconds);
  /// The bell that ends the ride. False when nobody rides.
  bool RingBell();

  Park park() const { return park_; }
  bool may_drive() const { return !rules_.day || park_ == Park::kRiding || park_ == Park::kOver; }
  bool rammed(std::size_t car) const { return rammed_[car]; }
  bool tapped(std::size_t car) const { return tapped_[car]; }
  /// Hard bumps into cars of people who are not friends.
  int spills() const { return spills_; }
  /// Seconds of fast driving.
  int thrills() const;
  int CountRammed() const;
  int CountTapped() const;
  const Rules& rules() const { return rules_; }
  const sdk::Outcome& outcome() const { return outcome_; }
  /// What the last tick brought that is worth a label; empty: nothing.
  const std::string& remark() const { return remark_; }
  /// Changes whenever something that a sensor says about the score or the park changes.
  std::uint64_t version() const { return version_; }

 private:
  void Judge(std::size_t car, const Impact& impact, const Arena& arena);
  bool WasPushed(std::size_t into) const;
  void Note(std::string remark);
  void End(sdk::Outcome::State state, std::string message);
  void CheckCollisions();
  void CheckDay();

  Rules rules_;
  Park park_;
  std::vector<char> rammed_;
  std::vector<char> tapped_;
  std::vector<double> since_spill_;   // s, by car
  std::vector<double> since_pushed_;  // s, by the car that did it
  int spills_ = 0;
  double fast_seconds_ = 0;
  double ride_left_;
  double paying_ = 0;
  double leaving_ = 0;
  std::uint64_t version_ = 1;
  std::string remark_;
  sdk::Outcome outcome_;
};

}  // namespace latchwork::bumper_cars

#endif  // LATCHWORK_BUMPER_CARS_REFEREE_H_

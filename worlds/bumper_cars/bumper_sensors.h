// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_BUMPER_CARS_BUMPER_SENSORS_H_
#define LATCHWORK_BUMPER_CARS_BUMPER_SENSORS_H_

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/random.h"
#include "latchwork/sdk/world.h"
#include "worlds/bumper_cars/arena.h"
#include "worlds/bumper_cars/referee.h"

namespace latchwork::bumper_cars {

/// Says what the agent perceives, as facts.
class BumperSensors {
 public:
  struct Eyes {
    double field_of_view = 3.5;  ///< rad.
    double range = 12;           ///< m.
    double noise = 0;
  };

  BumperSensors(logic::SymbolTable& symbols, std::uint64_t seed, const Eyes& eyes,
                const Arena& arena, std::string day);

  void Observe(std::uint64_t tick, const Arena& arena, const Referee& referee,
               std::span<sdk::Batch> sensors);

 private:
  using Facts = std::vector<logic::Fact>;

  void Say(Facts& facts, const char* predicate, std::initializer_list<logic::Term> terms);
  logic::Term Word(const std::string& word) {
    return logic::Term::Constant(symbols_->Intern(word));
  }
  void SayTask(const Referee& referee, Facts& facts);
  void SayPlaces(const Arena& arena, Facts& facts);
  void SayPeople(const Arena& arena, Facts& facts);
  void SaySelf(const Car& car, Facts& facts);
  void SayEyes(std::uint64_t tick, const Arena& arena, Facts& facts);
  void SayFeelers(const Arena& arena, Facts& facts);
  void SayTouch(const Arena& arena, Facts& facts);
  void SayScore(const Referee& referee, const Arena& arena, Facts& facts);

  logic::SymbolTable* symbols_;
  sdk::RandomStream random_;
  Eyes eyes_;
  std::vector<logic::Term> names_;  // of the cars
  std::string day_;
  std::uint64_t said_version_ = 0;
};

}  // namespace latchwork::bumper_cars

#endif  // LATCHWORK_BUMPER_CARS_BUMPER_SENSORS_H_

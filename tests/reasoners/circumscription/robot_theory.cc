// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reasoners/circumscription/robot_theory.h"

#include <string>

namespace latchwork::circumscription {
namespace {

std::string Name(const char* predicate, int index) {
  return std::string(predicate) + "(" + std::to_string(index) + ")";
}

std::string Name(const char* predicate, int index, int distance) {
  return std::string(predicate) + "(" + std::to_string(index) + "," + std::to_string(distance) +
         ")";
}

}  // namespace

RobotTheory::RobotTheory(int sonars) {
  AddAtoms(sonars);
  for (std::size_t i = 0; i < sonars_.size(); ++i) AddSonar(i);
  for (const Sector& sector : sectors_) AddSector(sector);
  theory.clauses.push_back({-ahead_, halt_});
  AddQueries();
}

void RobotTheory::AddAtoms(int sonars) {
  constexpr int kFirst = 1;
  constexpr int kSecond = 2;
  for (int i = 0; i < sonars; ++i) {
    Sonar sonar{};
    sonar.object = theory.Add({Role::kMinimized, kSecond, Name("object", i)});
    sonar.abnormal = theory.Add({Role::kMinimized, kFirst, Name("ab_sonar", i)});
    sonar.suspect = theory.Add({Role::kFixed, 1, Name("suspect", i)});
    for (int k = 0; k < kClasses; ++k) {
      sonar.distance[k] = theory.Add({Role::kMinimized, kSecond, Name("dist", i, k)});
      sonar.echo[k] = theory.Add({Role::kFixed, 1, Name("echo", i, k)});
    }
    sonars_.push_back(sonar);
  }
  for (int i = 0; i < kSectors; ++i) {
    sectors_.push_back({theory.Add({Role::kMinimized, kSecond, Name("virtual_object", i)}),
                        theory.Add({Role::kMinimized, kSecond, Name("blocked", i)}),
                        theory.Add({Role::kMinimized, kFirst, Name("ab_push", i)}),
                        theory.Add({Role::kFixed, 1, Name("push", i)}),
                        theory.Add({Role::kVarying, 1, Name("go", i)})});
  }
  ahead_ = theory.Add({Role::kMinimized, kSecond, "object_ahead"});
  halt_ = theory.Add({Role::kMinimized, kSecond, "halt_robot"});
}

void RobotTheory::AddSonar(std::size_t index) {
  const Sonar& sonar = sonars_[index];
  const Sonar& neighbour = sonars_[(index + 1) % sonars_.size()];
  const Sector& sector = sectors_[index * kSectors / sonars_.size()];
  for (int k = 0; k < kClasses; ++k) {
    theory.clauses.push_back({-sonar.echo[k], sonar.abnormal, sonar.object});
    theory.clauses.push_back({-sonar.echo[k], sonar.abnormal, sonar.distance[k]});
  }
  theory.clauses.push_back({-sonar.object, -sonar.distance[0], sector.blocked});
  theory.clauses.push_back({-sonar.object, -sonar.distance[1], sector.blocked});
  if (2 * index < sonars_.size()) {
    theory.clauses.push_back({-sonar.object, -sonar.distance[0], ahead_});
  } else {
    theory.clauses.push_back({-sonar.distance[0], -sonar.distance[2]});
  }
  theory.clauses.push_back({-sonar.suspect, sonar.abnormal, neighbour.abnormal});
  theory.clauses.push_back({-sonar.distance[0], -sonar.distance[1]});
}

void RobotTheory::AddSector(const Sector& sector) {
  theory.clauses.push_back({-sector.push, sector.given_up, sector.virtual_object});
  theory.clauses.push_back({-sector.virtual_object, sector.blocked});
  theory.clauses.push_back({sector.blocked, sector.go});
  theory.clauses.push_back({-sector.blocked, -sector.go});
}

void RobotTheory::AddQueries() {
  for (const Sector& sector : sectors_) {
    queries.push_back({sector.go});
    queries.push_back({-sector.blocked});
  }
  for (const Literal literal : {halt_, -halt_, ahead_, -ahead_}) queries.push_back({literal});
}

std::vector<Literal> RobotTheory::Latches(Dice& dice, int suspect_percent) const {
  std::vector<Literal> latches;
  for (const Sonar& sonar : sonars_) {
    const bool hears = dice.Roll(100) < 40;
    const int heard = dice.Roll(kClasses);
    for (int k = 0; k < kClasses; ++k) {
      latches.push_back(hears && k == heard ? sonar.echo[k] : -sonar.echo[k]);
    }
    latches.push_back(dice.Roll(100) < suspect_percent ? sonar.suspect : -sonar.suspect);
  }
  for (const Sector& sector : sectors_) {
    latches.push_back(dice.Roll(100) < 10 ? sector.push : -sector.push);
  }
  return latches;
}

}  // namespace latchwork::circumscription

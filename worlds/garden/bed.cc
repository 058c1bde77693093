// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/garden/bed.h"

#include <algorithm>
#include <cmath>

namespace latchwork::garden {

namespace {

constexpr double kLargest = 28;         // kg
constexpr double kGrowth = 0.028;       // 1/h in full light
constexpr double kFoodPerKilo = 1.2;    // g
constexpr double kFoodRelease = 0.008;  // 1/h, of the food in the soil
constexpr double kDrainage = 0.03;      // 1/h, of what the soil holds
constexpr double kCoverWarms = 4.5;     // °C

/// How well a plant grows at a temperature, 0 to 1.
double Warmth(double temperature) { return std::clamp((temperature - 6) / 14, 0.0, 1.0); }

}  // namespace

void Bed::Step(double hours, const Air& outside) {
  Air air = outside;
  if (covered_) {
    air.temperature += kCoverWarms;
    air.light *= 0.3;
    air.rain = 0;
  }
  MoveWater(hours, air);
  Grow(hours, air);
}

void Bed::MoveWater(double hours, const Air& air) {
  double leaves = 0;
  for (const Pumpkin& pumpkin : pumpkins_) leaves += pumpkin.alive() ? pumpkin.weight : 0;
  const double drying = air.light * std::clamp(air.temperature / 20, 0.0, 2.0);
  water_ += air.rain * kArea * hours;
  water_ -= (0.15 + drying * (1.6 + 0.045 * leaves)) * std::min(1.0, moisture() / 0.3) * hours;
  const double above = moisture() - kDrainsAbove;
  if (above > 0) {
    const double drained = std::min(above, kDrainage * hours) * kSoilHolds;
    food_ -= food_ * 0.4 * drained / water_;
    water_ -= drained;
  }
  water_ = std::clamp(water_, 0.0, kSoilHolds);
}

/// How well a plant is watered, 0 to 1: the roots of small ones do not reach deep.
double Bed::WaterFor(const Pumpkin& pumpkin) const {
  const double depth = 0.85 + 0.3 * std::sqrt(pumpkin.weight / kLargest);
  return std::clamp((moisture() * depth - 0.08) / (kWiltsBelow - 0.08), 0.0, 1.0);
}

void Bed::Grow(double hours, const Air& air) {
  std::vector<double> wanted(pumpkins_.size(), 0);  // kg
  double asked = 0;                                 // g
  double claims = 0;
  for (std::size_t n = 0; n < pumpkins_.size(); ++n) {
    const Pumpkin& p = pumpkins_[n];
    if (!p.alive()) continue;
    wanted[n] = kGrowth * p.vigour * p.weight * (1 - p.weight / kLargest) * air.light *
                Warmth(air.temperature) * WaterFor(p) * p.health * hours;
    asked += wanted[n] * kFoodPerKilo;
    claims += std::pow(p.weight, 1.4);
  }
  const double offered = std::min(food_, food_ * kFoodRelease * hours);
  for (std::size_t n = 0; n < pumpkins_.size(); ++n) {
    Pumpkin& p = pumpkins_[n];
    if (!p.alive()) continue;
    double served = 1;
    if (asked > offered && wanted[n] > 0) {
      const double share = offered * std::pow(p.weight, 1.4) / claims;
      served = std::min(1.0, share / (wanted[n] * kFoodPerKilo));
    }
    p.weight += wanted[n] * served;
    food_ -= wanted[n] * served * kFoodPerKilo;
    ChangeHealth(p, served, hours, air);
  }
  food_ = std::max(food_, 0.0);
}

void Bed::ChangeHealth(Pumpkin& pumpkin, double served, double hours, const Air& air) const {
  double change = 0.0025;  // 1/h
  const double dry = 1 - WaterFor(pumpkin);
  if (dry > 0.25) change = -0.02 * dry;
  if (moisture() > kRotsAbove) change -= 0.012;
  if (food_ > kBurnsAbove) change -= 0.01 * (food_ - kBurnsAbove) / kBurnsAbove;
  if (served < 0.35) change -= 0.006;
  if (air.temperature < 0) change -= std::min(0.3, -0.1 * air.temperature);
  pumpkin.health = std::clamp(pumpkin.health + change * hours, 0.0, 1.0);
}

void Bed::Harm(double health) {
  for (Pumpkin& pumpkin : pumpkins_) pumpkin.health = std::max(0.0, pumpkin.health - health);
}

double Bed::weight() const {
  double sum = 0;
  for (const Pumpkin& pumpkin : pumpkins_) sum += pumpkin.alive() ? pumpkin.weight : 0;
  return sum;
}

}  // namespace latchwork::garden

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_GARDEN_BED_H_
#define LATCHWORK_GARDEN_BED_H_

#include <vector>

namespace latchwork::garden {

/// What a plant and its fruit have come to.
struct Pumpkin {
  double vigour = 1;    ///< How fast it grows against others.
  double weight = 0.2;  ///< kg
  double health = 1;    ///< 0: dead
  bool alive() const { return health > 0; }
};

/// What the weather does to a bed in an hour.
struct Air {
  double temperature = 20;  ///< °C
  double light = 0;         ///< 0 to 1
  double rain = 0;          ///< mm/h
};

/// A bed of 4 m2 with pumpkins that live on the same soil.
///
/// Soil: holds 240 l; above three quarters of that it drains and loses food with the water. It
/// dries by sun and warmth, the faster the larger the plants. Growth: towards 28 kg, by light,
/// warmth, health, and as far as there is water and food. When there is less food than they ask
/// for, the larger plants take more than their share; in dry soil the smaller ones wilt first.
/// Health: falls in soil that is dry, soaked (it rots) or overfed, when a plant starves, and by
/// frost; else it slowly comes back. A dead plant stays dead.
/// A cover keeps frost, rain, and most of the light away.
class Bed {
 public:
  static constexpr double kSoilHolds = 240;     ///< l
  static constexpr double kArea = 4;            ///< m2
  static constexpr double kDrainsAbove = 0.75;  ///< Of what the soil holds.
  static constexpr double kRotsAbove = 0.85;
  static constexpr double kWiltsBelow = 0.3;
  static constexpr double kBurnsAbove = 50;  ///< g of food

  explicit Bed(std::vector<Pumpkin> pumpkins) : pumpkins_(std::move(pumpkins)) {}

  void Step(double hours, const Air& air);
  void AddWater(double litres) { water_ += litres; }
  void AddFood(double grams) { food_ += grams; }
  void SetCovered(bool covered) { covered_ = covered; }
  /// Takes that much health from every plant.
  void Harm(double health);

  double moisture() const { return water_ / kSoilHolds; }  ///< 0 to 1
  double food() const { return food_; }                    ///< g
  bool covered() const { return covered_; }
  const std::vector<Pumpkin>& pumpkins() const { return pumpkins_; }
  double weight() const;  ///< kg, of the living

 private:
  void MoveWater(double hours, const Air& air);
  void Grow(double hours, const Air& air);
  void ChangeHealth(Pumpkin& pumpkin, double served, double hours, const Air& air) const;
  double WaterFor(const Pumpkin& pumpkin) const;

  std::vector<Pumpkin> pumpkins_;
  double water_ = 0.55 * kSoilHolds;
  double food_ = 30;
  bool covered_ = false;
};

}  // namespace latchwork::garden

#endif  // LATCHWORK_GARDEN_BED_H_

// SPDX-License-Identifier: BSD-3-Clause
//
// Turns to the free direction that is nearest to where it is pushed, goes as fast as the way ahead
// allows, and stops before what is close ahead. Source: Brooks, A robust layered control system for
// a mobile robot (1986); there forces add up, which leaves a robot standing before a box.
#include <algorithm>
#include <cmath>
#include <optional>

#include "reasoners/brooks/behaviour.h"

namespace latchwork::brooks {
namespace {

using logic::Fact;
using logic::Term;

constexpr double kWayWanted = 0.6;  // m that a direction has to be free to be chosen
constexpr double kBlocked = 6.0;    // what a direction costs that is not free at all, rad
constexpr double kInertia = 0.3;    // what turning costs, so that it does not dither before a box
constexpr std::size_t kDirections = 48;

struct Echo {
  std::int64_t sonar = 0;
  double distance = 0.0;  ///< m, from the centre
  double angle = 0.0;
};

class Avoid final : public Behaviour {
 public:
  Avoid(const sdk::Body& body, const Whims& whims, logic::SymbolTable& symbols)
      : whims_(whims),
        sense_range_(BodyNumber(body, "sense_range", 2.5)),
        halt_gap_(BodyNumber(body, "halt_gap", 0.15)),
        halt_half_angle_(BodyNumber(body, "halt_half_angle", 0.5)),
        half_cone_(BodyNumber(body, "cone_half_angle", 0.218)),
        margin_(BodyNumber(body, "margin", 0.1)),
        horizon_(BodyNumber(body, "horizon", 3.0)),
        turn_tolerance_(BodyNumber(body, "turn_tolerance", 0.05)),
        aligned_within_(BodyNumber(body, "aligned_within", 0.9)),
        max_speed_(BodyNumber(body, "max_speed", 0.6)),
        headway_(BodyNumber(body, "headway", 0.7)),
        least_push_(BodyNumber(body, "least_force", 0.05)),
        sonar_reading_(symbols.Intern("sonar_reading")),
        sonar_direction_(symbols.Intern("sonar_direction")),
        robot_radius_(symbols.Intern("robot_radius")),
        distance_(symbols.Intern("distance")),
        direction_(symbols.Intern("direction")),
        fwd_(symbols.Intern("fwd")),
        turn_(symbols.Intern("turn")),
        halt_(symbols.Intern("halt")) {}

  void Act(std::span<const sdk::Latch> latches, std::vector<Fact>& acts) override {
    Sense(latches);
    const std::optional<double> wanted = Wanted(latches);
    ++cycle_;
    const bool close = IsCloseAhead();
    if (close) acts.emplace_back(halt_);
    if (!wanted) return;
    const double angle = FreeDirectionNear(*wanted);
    if (std::abs(angle) > turn_tolerance_) acts.push_back(Fact(turn_, {Term::Real(angle)}));
    const double bend = 1.0 - std::abs(angle) / aligned_within_;
    if (close || bend <= 0.0) return;
    const double speed = std::min(max_speed_, FreeWay(0.0) / headway_) * bend;
    if (speed > 0.0) acts.push_back(Fact(fwd_, {Term::Real(speed)}));
  }

 private:
  void Sense(std::span<const sdk::Latch> latches) {
    ForEachFact(latches, {robot_radius_, 1}, [&](auto terms) { radius_ = terms[0].number(); });
    echoes_.clear();
    ForEachFact(latches, {sonar_reading_, 2}, [&](auto terms) {
      if (terms[1].number() > sense_range_) return;
      echoes_.push_back({terms[0].integer(), radius_ + terms[1].number(), 0.0});
    });
    ForEachFact(latches, {sonar_direction_, 2}, [&](auto terms) {
      for (Echo& echo : echoes_) {
        if (echo.sonar == terms[0].integer()) echo.angle = terms[1].number();
      }
    });
  }

  /// Away from the objects from above, the nearer the stronger; on a whim, where there are none.
  std::optional<double> Wanted(std::span<const sdk::Latch> latches) const {
    double x = 0.0;
    double y = 0.0;
    bool pushed = false;
    ForEachFact(latches, {direction_, 2}, [&](auto direction) {
      ForEachFact(latches, {distance_, 2}, [&](auto distance) {
        if (!(distance[0] == direction[0])) return;
        const double strength = 1.0 / std::max(distance[1].number(), 0.01);
        x -= strength * std::cos(direction[1].number());
        y -= strength * std::sin(direction[1].number());
        pushed = true;
      });
    });
    if (pushed) {
      return std::hypot(x, y) < least_push_ ? std::nullopt : std::optional(std::atan2(y, x));
    }
    if (!whims_.active) return std::nullopt;
    if (cycle_ % whims_.every != 0) return 0.0;
    return whims_.random.Between(-std::numbers::pi, std::numbers::pi, cycle_);
  }

  bool IsCloseAhead() const {
    return std::any_of(echoes_.begin(), echoes_.end(), [&](const Echo& echo) {
      return std::abs(echo.angle) <= halt_half_angle_ && echo.distance <= radius_ + halt_gap_;
    });
  }

  /// How far the hull and a margin beside it could go in a direction. An echo counts at the place
  /// in its cone that is worst.
  double FreeWay(double direction) const {
    double way = horizon_;
    for (const Echo& echo : echoes_) {
      const double off = std::max(0.0, std::abs(WrapAngle(echo.angle - direction)) - half_cone_);
      if (off >= std::numbers::pi / 2.0) continue;
      if (echo.distance * std::sin(off) >= radius_ + margin_) continue;
      way = std::min(way, echo.distance * std::cos(off) - radius_ - margin_);
    }
    return std::max(0.0, way);
  }

  double FreeDirectionNear(double wanted) const {
    double best = wanted;
    double least = CostOf(wanted, wanted);
    for (std::size_t i = 0; i < kDirections; ++i) {
      const double direction =
          WrapAngle(2.0 * std::numbers::pi * static_cast<double>(i) / kDirections);
      const double cost = CostOf(direction, wanted);
      if (cost >= least) continue;
      least = cost;
      best = direction;
    }
    return best;
  }

  double CostOf(double direction, double wanted) const {
    const double missing = std::max(0.0, 1.0 - FreeWay(direction) / kWayWanted);
    return std::abs(WrapAngle(direction - wanted)) + kBlocked * missing +
           kInertia * std::abs(direction);
  }

  Whims whims_;
  double sense_range_, halt_gap_, halt_half_angle_, half_cone_, margin_, horizon_, turn_tolerance_,
      aligned_within_, max_speed_, headway_, least_push_;
  logic::Symbol sonar_reading_, sonar_direction_, robot_radius_, distance_, direction_, fwd_, turn_,
      halt_;
  double radius_ = 0.25;
  std::vector<Echo> echoes_;
  std::uint64_t cycle_ = 0;
};

}  // namespace

std::unique_ptr<Behaviour> MakeAvoid(const sdk::Body& body, const Whims& whims,
                                     logic::SymbolTable& symbols) {
  return std::make_unique<Avoid>(body, whims, symbols);
}

}  // namespace latchwork::brooks

// SPDX-License-Identifier: BSD-3-Clause
//
// Straight to the destination; without one, where it is told to explore, for a while in one
// direction and then in another.
#include <cmath>
#include <optional>

#include "reasoners/brooks/behaviour.h"

namespace latchwork::brooks {
namespace {

using logic::Fact;
using logic::Term;

class Explore final : public Behaviour {
 public:
  Explore(const sdk::Body& body, const Whims& whims, logic::SymbolTable& symbols)
      : whims_(whims),
        arrive_tolerance_(BodyNumber(body, "arrive_tolerance", 0.2)),
        push_distance_(BodyNumber(body, "push_distance", 1.0)),
        curr_location_(symbols.Intern("curr_location")),
        curr_heading_(symbols.Intern("curr_heading")),
        move_cmd_(symbols.Intern("move_cmd")),
        object_(symbols.Intern("object")),
        distance_(symbols.Intern("distance")),
        direction_(symbols.Intern("direction")),
        push_object_(Term::Constant(symbols.Intern("push_object"))) {}

  void Act(std::span<const sdk::Latch> latches, std::vector<Fact>& acts) override {
    const std::uint64_t whim = cycle_++ / whims_.every;
    double x = 0.0;
    double y = 0.0;
    std::optional<double> heading;
    ForEachFact(latches, {curr_heading_, 1}, [&](auto terms) { heading = terms[0].number(); });
    ForEachFact(latches, {curr_location_, 2}, [&](auto terms) {
      x = terms[0].number();
      y = terms[1].number();
    });
    if (!heading) return;
    bool is_sent = false;
    std::optional<double> course;
    ForEachFact(latches, {move_cmd_, 2}, [&](auto terms) {
      const double dx = terms[0].number() - x;
      const double dy = terms[1].number() - y;
      is_sent = true;
      if (std::hypot(dx, dy) > arrive_tolerance_) course = std::atan2(dy, dx);
    });
    if (!is_sent && whims_.active) {
      course = whims_.random.Between(-std::numbers::pi, std::numbers::pi, whim);
    }
    if (course) Push(WrapAngle(*course - *heading + std::numbers::pi), acts);
  }

 private:
  void Push(double from, std::vector<Fact>& acts) const {
    acts.push_back(Fact(object_, {push_object_}));
    acts.push_back(Fact(distance_, {push_object_, Term::Real(push_distance_)}));
    acts.push_back(Fact(direction_, {push_object_, Term::Real(from)}));
  }

  Whims whims_;
  double arrive_tolerance_, push_distance_;
  logic::Symbol curr_location_, curr_heading_, move_cmd_, object_, distance_, direction_;
  Term push_object_;
  std::uint64_t cycle_ = 0;
};

}  // namespace

std::unique_ptr<Behaviour> MakeExplore(const sdk::Body& body, const Whims& whims,
                                       logic::SymbolTable& symbols) {
  return std::make_unique<Explore>(body, whims, symbols);
}

}  // namespace latchwork::brooks

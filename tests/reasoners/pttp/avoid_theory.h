// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_PTTP_AVOID_THEORY_H_
#define LATCHWORK_TESTS_REASONERS_PTTP_AVOID_THEORY_H_

#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::pttp {

/// A theory of the size of an obstacle-avoidance layer: sonar readings become objects, their force
/// a turn or a speed.
inline constexpr std::string_view kAvoidTheory = R"(
fof(seen, axiom, ![N, D] : ((sonar_reading(N, D) & $less(D, 4.0)) => object(sonar_obj(N)))).
fof(seen_at, axiom, ![N, D] : ((sonar_reading(N, D) & $less(D, 4.0)) => distance(sonar_obj(N), D))).
fof(seen_where, axiom, ![N, A] : (sonar_direction(N, A) => direction(sonar_obj(N), A))).
fof(ahead, axiom, ![O, D, A] : ((object(O) & distance(O, D) & direction(O, A) & $less(D, 0.6)
    & $lesseq(-0.5, A) & $lesseq(A, 0.5)) => object_ahead(O))).
fof(halt_ahead, axiom, ![O] : (object_ahead(O) => halt_robot)).
fof(heading, axiom, ![S, A] : (get_force(S, A) => heading_angle(A))).
fof(speed, axiom, ![S, A, V] : ((get_force(S, A) & V = $product(0.5, S)) => heading_speed(V))).
fof(turn_left, axiom, ![A] : ((heading_angle(A) & $greater(A, 0.1)) => turn(A))).
fof(turn_right, axiom, ![A] : ((heading_angle(A) & $less(A, -0.1)) => turn(A))).
fof(forward, axiom, ![A, V] : ((heading_angle(A) & $lesseq(-0.1, A) & $lesseq(A, 0.1)
    & heading_speed(V) & $greater(V, 0.01) & ~ halt_robot) => fwd(V))).
fof(stop, axiom, (halt_robot => halt)).
)";

class GetForce final : public sdk::Attachment, private sdk::AnswerSink {
 public:
  explicit GetForce(logic::SymbolTable& symbols) {
    using logic::Atom;
    using logic::Term;
    query_.push_back({true, Atom(symbols.Intern("object"), {Term::Var(0)})});
    query_.push_back({true, Atom(symbols.Intern("distance"), {Term::Var(0), Term::Var(1)})});
    query_.push_back({true, Atom(symbols.Intern("direction"), {Term::Var(0), Term::Var(2)})});
    signature_.predicate = "get_force";
    signature_.arguments = {{{"strength", sdk::ArgumentType::kReal, ""}, Mode::kOut},
                            {{"angle", sdk::ArgumentType::kReal, "rad"}, Mode::kOut}};
  }
  const Signature& signature() const override { return signature_; }
  void Call(std::span<const logic::Term> /*inputs*/, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override {
    x_ = y_ = 0;
    context.ForEachProvable(query_, 3, *this);
    const logic::Term results[] = {logic::Term::Real(std::hypot(x_, y_)),
                                   logic::Term::Real(std::atan2(y_, x_))};
    outputs.Answer(results);
  }

 private:
  void Answer(std::span<const logic::Term> terms) override {
    const double weight = 1 / (terms[1].number() * terms[1].number());
    x_ -= weight * std::cos(terms[2].number());
    y_ -= weight * std::sin(terms[2].number());
  }

  Signature signature_;
  std::vector<logic::Literal> query_;
  double x_ = 0;
  double y_ = 0;
};

inline constexpr int kSonars = 16;

inline void LoadAvoid(AgentMind& mind) {
  mind.Input("sonar_reading", 2);
  mind.Input("sonar_direction", 2);
  mind.Input("object", 1);
  mind.Input("distance", 2);
  mind.Input("direction", 2);
  mind.Minimize("halt_robot", 0);
  mind.Minimize("object", 1);
  mind.Minimize("distance", 2);
  mind.Minimize("direction", 2);
  mind.body.attachments.push_back(std::make_shared<GetForce>(mind.symbols));
  mind.Goal("fwd(V)");
  mind.Goal("turn(A)");
  mind.Goal("halt");
  mind.Load();
  std::vector<std::string> directions;
  directions.reserve(kSonars);
  for (int i = 0; i < kSonars; ++i) {
    directions.push_back("sonar_direction(" + std::to_string(i) + ", " +
                         std::to_string(0.3926990817 * i - 3.0) + ")");
  }
  mind.Latch(0, directions);
}

/// Readings of one tick: walls around, nearer on one side.
inline void SenseAvoid(AgentMind& mind, int tick) {
  std::vector<std::string> readings;
  for (int i = 0; i < kSonars; ++i) {
    const double distance = 1.0 + 0.1 * ((i * 7 + tick) % 16);
    readings.push_back("sonar_reading(" + std::to_string(i) + ", " + std::to_string(distance) +
                       ")");
  }
  mind.Latch(1, readings);
}

}  // namespace latchwork::pttp

#endif  // LATCHWORK_TESTS_REASONERS_PTTP_AVOID_THEORY_H_

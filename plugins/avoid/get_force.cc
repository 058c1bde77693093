// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/avoid/get_force.h"

#include <array>

namespace latchwork::avoid {

const sdk::Attachment::Signature& GetForce::signature() const {
  static const Signature signature{"get_force",
                                   {{{"strength", sdk::ArgumentType::kReal, ""}, Mode::kOut},
                                    {{"direction", sdk::ArgumentType::kReal, "rad"}, Mode::kOut}},
                                   "sum of the forces of all provable objects"};
  return signature;
}

void GetForce::Call(std::span<const logic::Term> /*inputs*/, sdk::AttachmentContext& context,
                    sdk::AnswerSink& outputs) {
  law_.robot_radius = objects_.RobotRadius(context);
  if (law_.robot_radius < 0.0) return;
  const Force force = SumForces(law_, objects_.Collect(context));
  const std::array<logic::Term, 2> answer{logic::Term::Real(force.strength),
                                          logic::Term::Real(force.direction)};
  outputs.Answer(answer);
}

}  // namespace latchwork::avoid

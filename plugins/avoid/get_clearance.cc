// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/avoid/get_clearance.h"

#include <array>

namespace latchwork::avoid {

const sdk::Attachment::Signature& GetClearance::signature() const {
  static const Signature signature{"get_clearance",
                                   {{{"way", sdk::ArgumentType::kReal, "m"}, Mode::kOut}},
                                   "free way straight ahead, over all provable objects"};
  return signature;
}

void GetClearance::Call(std::span<const logic::Term> /*inputs*/, sdk::AttachmentContext& context,
                        sdk::AnswerSink& outputs) {
  const double radius = objects_.RobotRadius(context);
  if (radius < 0.0) return;
  const double way = FreeAhead(radius, options_.margin, options_.half_cone, options_.horizon,
                               objects_.Collect(context));
  const std::array<logic::Term, 1> answer{logic::Term::Real(way)};
  outputs.Answer(answer);
}

}  // namespace latchwork::avoid

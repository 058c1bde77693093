// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/seek/bearing.h"

#include <array>
#include <cmath>
#include <numbers>

namespace latchwork::seek {
namespace {

double WrapAngle(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

}  // namespace

const sdk::Attachment::Signature& Bearing::signature() const {
  using sdk::ArgumentType;
  static const Signature signature{"bearing",
                                   {{{"x0", ArgumentType::kReal, "m"}, Mode::kIn},
                                    {{"y0", ArgumentType::kReal, "m"}, Mode::kIn},
                                    {{"heading", ArgumentType::kReal, "rad"}, Mode::kIn},
                                    {{"x", ArgumentType::kReal, "m"}, Mode::kIn},
                                    {{"y", ArgumentType::kReal, "m"}, Mode::kIn},
                                    {{"distance", ArgumentType::kReal, "m"}, Mode::kOut},
                                    {{"bearing", ArgumentType::kReal, "rad"}, Mode::kOut}},
                                   "a place as the robot sees it"};
  return signature;
}

void Bearing::Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& /*context*/,
                   sdk::AnswerSink& outputs) {
  const double dx = inputs[3].number() - inputs[0].number();
  const double dy = inputs[4].number() - inputs[1].number();
  const std::array<logic::Term, 2> answer{
      logic::Term::Real(std::hypot(dx, dy)),
      logic::Term::Real(WrapAngle(std::atan2(dy, dx) - inputs[2].number()))};
  outputs.Answer(answer);
}

}  // namespace latchwork::seek

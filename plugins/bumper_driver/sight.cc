// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/bumper_driver/sight.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace latchwork::bumper_driver {
namespace {

using logic::Term;
using sdk::ArgumentType;
using Argument = sdk::Attachment::Argument;
using Inputs = std::span<const Term>;

/// A function from numbers to numbers.
class Formula final : public sdk::Attachment {
 public:
  using Function = void (*)(Inputs inputs, sdk::AnswerSink& outputs);

  Formula(Signature signature, Function function)
      : signature_(std::move(signature)), function_(function) {}

  const Signature& signature() const override { return signature_; }
  void Call(Inputs inputs, sdk::AttachmentContext& /*context*/, sdk::AnswerSink& outputs) override {
    function_(inputs, outputs);
  }

 private:
  Signature signature_;
  Function function_;
};

Argument In(const char* name, const char* unit) {
  return {{name, ArgumentType::kReal, unit}, sdk::Attachment::Mode::kIn};
}
Argument Out(const char* name, const char* unit) {
  return {{name, ArgumentType::kReal, unit}, sdk::Attachment::Mode::kOut};
}

void DistanceTo(Inputs in, sdk::AnswerSink& outputs) {
  const std::array<Term, 1> answer{
      Term::Real(std::hypot(in[2].number() - in[0].number(), in[3].number() - in[1].number()))};
  outputs.Answer(answer);
}

void BearingTo(Inputs in, sdk::AnswerSink& outputs) {
  const double direction =
      std::atan2(in[4].number() - in[1].number(), in[3].number() - in[0].number());
  const std::array<Term, 1> answer{
      Term::Real(std::remainder(direction - in[2].number(), 2 * std::numbers::pi))};
  outputs.Answer(answer);
}

void PlaceAt(Inputs in, sdk::AnswerSink& outputs) {
  const double direction = in[2].number() + in[4].number();
  const std::array<Term, 2> answer{
      Term::Real(in[0].number() + in[3].number() * std::cos(direction)),
      Term::Real(in[1].number() + in[3].number() * std::sin(direction))};
  outputs.Answer(answer);
}

}  // namespace

std::vector<std::shared_ptr<sdk::Attachment>> SightAttachments() {
  const Argument x0 = In("x0", "m");
  const Argument y0 = In("y0", "m");
  const Argument heading = In("heading", "rad");
  return {
      std::make_shared<Formula>(
          sdk::Attachment::Signature{"distance_to",
                                     {x0, y0, In("x", "m"), In("y", "m"), Out("distance", "m")},
                                     "from place to place"},
          &DistanceTo),
      std::make_shared<Formula>(sdk::Attachment::Signature{"bearing_to",
                                                           {x0, y0, heading, In("x", "m"),
                                                            In("y", "m"), Out("bearing", "rad")},
                                                           "where a place is as seen from a pose"},
                                &BearingTo),
      std::make_shared<Formula>(
          sdk::Attachment::Signature{"place_at",
                                     {x0, y0, heading, In("distance", "m"), In("bearing", "rad"),
                                      Out("x", "m"), Out("y", "m")},
                                     "the place of what is seen from a pose"},
          &PlaceAt)};
}

}  // namespace latchwork::bumper_driver

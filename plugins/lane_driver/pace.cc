// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/lane_driver/pace.h"

#include <algorithm>
#include <array>

namespace latchwork::lane_driver {
namespace {

using sdk::ArgumentType;
using Mode = sdk::Attachment::Mode;
using Argument = sdk::Attachment::Argument;

const Argument kSpeed{{"speed", ArgumentType::kReal, "m/s"}, Mode::kIn};
const Argument kWanted{{"wanted", ArgumentType::kReal, "m/s"}, Mode::kIn};
const Argument kGap{{"gap", ArgumentType::kReal, "m"}, Mode::kIn};
const Argument kRelative{{"relative_speed", ArgumentType::kReal, "m/s"}, Mode::kIn};
const Argument kAcceleration{{"acceleration", ArgumentType::kReal, "m/s^2"}, Mode::kOut};

constexpr double kPerSpeed = 0.4;     // 1/s
constexpr double kPerGap = 0.1;       // 1/s^2
constexpr double kPerRelative = 0.7;  // 1/s
constexpr double kGentle = 1.5;       // m/s^2
constexpr double kHardest = 8.0;      // m/s^2
constexpr double kLeastGap = 0.5;     // m; nearer than this all braking is hardest

double Free(double speed, double wanted) {
  return std::clamp(kPerSpeed * (wanted - speed), -2.0, kGentle);
}

double Needed(double gap, double relative) {
  if (relative >= 0) return 0;
  return std::min(relative * relative / (2 * std::max(gap - 1.0, kLeastGap)), 100.0);
}

void Answer(sdk::AnswerSink& outputs, double value) {
  const std::array<logic::Term, 1> answer{logic::Term::Real(value)};
  outputs.Answer(answer);
}

}  // namespace

const sdk::Attachment::Signature& FreePace::signature() const {
  static const Signature signature{
      "free_pace", {kSpeed, kWanted, kAcceleration}, "the acceleration with nobody ahead"};
  return signature;
}

void FreePace::Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& /*context*/,
                    sdk::AnswerSink& outputs) {
  Answer(outputs, Free(inputs[0].number(), inputs[1].number()));
}

const sdk::Attachment::Signature& Pace::signature() const {
  static const Signature signature{"pace",
                                   {kSpeed, kWanted, kGap, kRelative, kAcceleration},
                                   "the acceleration behind another car"};
  return signature;
}

void Pace::Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& /*context*/,
                sdk::AnswerSink& outputs) {
  const double speed = inputs[0].number();
  const double gap = inputs[2].number();
  const double relative = inputs[3].number();
  const double held = habits_.standstill_gap + habits_.headway * speed;
  double pace = std::max(kPerGap * (gap - held), -kGentle) + kPerRelative * relative;
  const double needed = Needed(gap, relative);
  if (needed > kGentle) pace = std::min(pace, -1.1 * needed);
  pace = std::min(pace, Free(speed, inputs[1].number()));
  Answer(outputs, std::max(pace, -kHardest));
}

const sdk::Attachment::Signature& BrakingNeeded::signature() const {
  static const Signature signature{
      "braking_needed",
      {kGap, kRelative, {{"braking", ArgumentType::kReal, "m/s^2"}, Mode::kOut}},
      "what it takes not to touch the car ahead"};
  return signature;
}

void BrakingNeeded::Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& /*context*/,
                         sdk::AnswerSink& outputs) {
  Answer(outputs, Needed(inputs[0].number(), inputs[1].number()));
}

}  // namespace latchwork::lane_driver

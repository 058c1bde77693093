// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_LANE_DRIVER_PACE_H_
#define LATCHWORK_PLUGINS_LANE_DRIVER_PACE_H_

#include <span>

#include "latchwork/sdk/attachment.h"

namespace latchwork::lane_driver {

/// free_pace(Speed, Wanted, A): the acceleration with nobody ahead, -2 to 1.5 m/s^2.
class FreePace final : public sdk::Attachment {
 public:
  const Signature& signature() const override;
  void Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override;
};

/// pace(Speed, Wanted, Gap, Relative, A): the acceleration behind a car that is `Gap` ahead and
/// draws away with `Relative`: the gap is held at a constant headway, by the acceleration of
/// free_pace at most, and where the car ahead is closed in on so fast that this needs more than
/// 1.5 m/s^2 of braking, at least as hard as is needed.
class Pace final : public sdk::Attachment {
 public:
  struct Habits {
    double headway = 1.2;       ///< s
    double standstill_gap = 3;  ///< m
  };
  explicit Pace(const Habits& habits) : habits_(habits) {}
  const Signature& signature() const override;
  void Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override;

 private:
  Habits habits_;
};

/// braking_needed(Gap, Relative, B): the constant deceleration (m/s^2) that just keeps a car from
/// touching the one ahead; 0 when it is not closed in on.
class BrakingNeeded final : public sdk::Attachment {
 public:
  const Signature& signature() const override;
  void Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override;
};

}  // namespace latchwork::lane_driver

#endif  // LATCHWORK_PLUGINS_LANE_DRIVER_PACE_H_

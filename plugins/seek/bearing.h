// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_SEEK_BEARING_H_
#define LATCHWORK_PLUGINS_SEEK_BEARING_H_

#include <span>

#include "latchwork/sdk/attachment.h"

namespace latchwork::seek {

/// bearing(X0, Y0, H, X, Y, Distance, Bearing): the place (X, Y) as seen from (X0, Y0) with heading
/// H. The bearing is relative to the heading, counter-clockwise, in (-pi, pi].
class Bearing final : public sdk::Attachment {
 public:
  const Signature& signature() const override;
  void Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override;
};

}  // namespace latchwork::seek

#endif  // LATCHWORK_PLUGINS_SEEK_BEARING_H_

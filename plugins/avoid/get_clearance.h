// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_AVOID_GET_CLEARANCE_H_
#define LATCHWORK_PLUGINS_AVOID_GET_CLEARANCE_H_

#include <span>

#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/attachment.h"
#include "plugins/avoid/known_objects.h"

namespace latchwork::avoid {

/// As FreeAhead takes them.
struct ClearanceOptions {
  double margin = 0.1;      ///< m
  double half_cone = 0.22;  ///< rad
  double horizon = 3.0;     ///< m
};

/// get_clearance(Way): how far the robot can roll straight ahead, over all provable objects, see
/// FreeAhead. False while the robot's radius is unknown.
class GetClearance final : public sdk::Attachment {
 public:
  GetClearance(const ClearanceOptions& options, logic::SymbolTable& symbols)
      : options_(options), objects_(symbols) {}

  const Signature& signature() const override;
  void Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override;

 private:
  ClearanceOptions options_;
  KnownObjects objects_;
};

}  // namespace latchwork::avoid

#endif  // LATCHWORK_PLUGINS_AVOID_GET_CLEARANCE_H_

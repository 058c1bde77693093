// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_AVOID_GET_FORCE_H_
#define LATCHWORK_PLUGINS_AVOID_GET_FORCE_H_

#include <span>

#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/attachment.h"
#include "plugins/avoid/force.h"
#include "plugins/avoid/known_objects.h"

namespace latchwork::avoid {

/// get_force(Strength, Direction): the sum of the forces of all provable objects, see SumForces.
/// False while the robot's radius is unknown. Source: LSA (IJCAI-99), section 5.
class GetForce final : public sdk::Attachment {
 public:
  /// The radius comes from the fact robot_radius(R).
  GetForce(const ForceLaw& law, logic::SymbolTable& symbols) : law_(law), objects_(symbols) {}

  const Signature& signature() const override;
  void Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override;

 private:
  ForceLaw law_;
  KnownObjects objects_;
};

}  // namespace latchwork::avoid

#endif  // LATCHWORK_PLUGINS_AVOID_GET_FORCE_H_

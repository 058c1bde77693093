// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_AVOID_KNOWN_OBJECTS_H_
#define LATCHWORK_PLUGINS_AVOID_KNOWN_OBJECTS_H_

#include <span>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/attachment.h"
#include "plugins/avoid/force.h"

namespace latchwork::avoid {

/// Collects every provable object with a provable distance and direction: object(O) & distance(O,
/// D) & direction(O, A). An object named sonar_obj(N) was sensed; any other is virtual. What is no
/// finite number, or has a negative distance, is left out. Thread rule: used by one thread.
class KnownObjects {
 public:
  explicit KnownObjects(logic::SymbolTable& symbols);

  /// Valid until the next call.
  std::span<const RelativeObject> Collect(sdk::AttachmentContext& context);
  /// Of the fact robot_radius(R), m; a negative value when there is none.
  double RobotRadius(sdk::AttachmentContext& context);

 private:
  logic::Symbol sensed_;
  std::vector<logic::Literal> objects_query_;
  std::vector<logic::Literal> radius_query_;
  std::vector<RelativeObject> objects_;
};

}  // namespace latchwork::avoid

#endif  // LATCHWORK_PLUGINS_AVOID_KNOWN_OBJECTS_H_

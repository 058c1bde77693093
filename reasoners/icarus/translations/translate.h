// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_TRANSLATE_H_
#define LATCHWORK_ICARUS_TRANSLATE_H_

#include <string>

#include "reasoners/icarus/translations/reactive_plan.h"

namespace latchwork::icarus {

/// The Icarus program, in its canonical layout, that acts like the plans of a file without errors:
/// called with the arguments of a plan, the skill of its name comes to the plan's act in every
/// state of the world. Where a goal is reached a universal plan is True, a teleo-reactive tree
/// False. Source: Shapiro and Langley (Agents'99), tables 5 and 6 and figure 2.
std::string TranslateToIcarus(const ReactivePlanFile& file);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_TRANSLATE_H_

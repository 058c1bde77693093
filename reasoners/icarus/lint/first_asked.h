// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_FIRST_ASKED_H_
#define LATCHWORK_ICARUS_FIRST_ASKED_H_

#include <cstdint>

#include "reasoners/icarus/language/program.h"

namespace latchwork::icarus {

/// The clause that is asked first whenever the skill is called; null when there is none.
const Clause* FirstAsked(const Skill& skill);
/// The skill that this clause calls, if need be within a negation, or kNoSkill.
std::uint32_t FirstCalled(const Skill& skill);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_FIRST_ASKED_H_

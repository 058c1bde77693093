// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_PROGRAM_TOPS_H_
#define LATCHWORK_ICARUS_PROGRAM_TOPS_H_

#include <cstdint>
#include <vector>

#include "reasoners/icarus/language/program.h"

namespace latchwork::icarus {

/// The skills that cycles may begin with. With no top known, the first skill and those that no
/// others call may be it. kNoSkill for a top that is no skill.
std::vector<std::uint32_t> TopsOf(const Program& program, const CheckOptions& options);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_PROGRAM_TOPS_H_

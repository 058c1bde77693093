// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_PROGRAM_BUILDER_H_
#define LATCHWORK_ICARUS_PROGRAM_BUILDER_H_

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"

namespace latchwork::icarus {

/// Fills skills, constants and facts from the forms of `program.source`; every offence against the
/// grammar is a finding, and what offends is left out.
void BuildProgram(Program& program, Findings& findings);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_PROGRAM_BUILDER_H_

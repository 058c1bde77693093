// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_TOP_CHECK_H_
#define LATCHWORK_ICARUS_TOP_CHECK_H_

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/language/source_tree.h"

namespace latchwork::icarus {

/// Whether this clause, which `source` has, may be a top: a call of a skill of the program. What
/// else it is, is reported.
bool CheckTopCall(const Program& program, const SourceTree& source, const Clause& clause,
                  Reporter& reporter);
/// Whether the skill has as many parameters as the call has arguments; else reports that.
bool CheckParameters(const Program& program, const Clause& call, Reporter& reporter);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_TOP_CHECK_H_

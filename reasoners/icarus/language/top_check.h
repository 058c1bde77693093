// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_TOP_CHECK_H_
#define LATCHWORK_ICARUS_TOP_CHECK_H_

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/language/source_tree.h"

namespace latchwork::icarus {

/// Says that a top call, which `source` has, names no skill of the program.
void ReportNoSuchTop(const Program& program, const SourceTree& source, const Term& head,
                     Reporter& reporter);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_TOP_CHECK_H_

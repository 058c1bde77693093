// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONFIG_REPEATS_H_
#define LATCHWORK_CONFIG_REPEATS_H_

#include "latchwork/config/xml.h"
#include "latchwork/logic/diagnostic.h"

namespace latchwork::config {

/// Reports what stands twice in one element and may stand there once: a <param> of a name, a
/// <reasoner>, a <fallback>.
void CheckRepeats(const Element& element, logic::Diagnostics& diagnostics);

}  // namespace latchwork::config

#endif  // LATCHWORK_CONFIG_REPEATS_H_

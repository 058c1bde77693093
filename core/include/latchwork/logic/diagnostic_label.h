// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_DIAGNOSTIC_LABEL_H_
#define LATCHWORK_LOGIC_DIAGNOSTIC_LABEL_H_

#include <string>
#include <string_view>

#include "latchwork/logic/diagnostic.h"

namespace latchwork::logic {

/// As Format(diagnostic), with `label` ("warning", "note", "error[I004]") where that says "error".
std::string Format(const Diagnostic& diagnostic, std::string_view label);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_DIAGNOSTIC_LABEL_H_

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/schedule/fault.h"

namespace latchwork::schedule {

std::string_view Name(FaultKind kind) {
  switch (kind) {
    case FaultKind::kException:
      return "exception";
    case FaultKind::kTimeout:
      return "timeout";
    case FaultKind::kOverBudget:
      return "over budget";
    case FaultKind::kInconsistent:
      return "inconsistent";
    case FaultKind::kFailed:
      return "failed";
    case FaultKind::kBadConclusion:
      return "bad conclusion";
    case FaultKind::kAdmission:
      return "admission";
  }
  return "";
}

}  // namespace latchwork::schedule

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/decision.h"

#include <string_view>

namespace latchwork::sdk {

void Decision::Clear() {
  status = Status::kFailed;
  limit = Limit::kNone;
  conclusions.clear();
  undecided.clear();
  states.clear();
  assumptions.clear();
  statistics = Statistics{};
  message.clear();
}

std::string_view Name(Status status) {
  switch (status) {
    case Status::kProved:
      return "proved";
    case Status::kRefuted:
      return "refuted";
    case Status::kUnknown:
      return "unknown";
    case Status::kInconsistent:
      return "inconsistent";
    case Status::kFailed:
      return "failed";
  }
  return "";
}

std::string_view Name(Limit limit) {
  switch (limit) {
    case Limit::kNone:
      return "none";
    case Limit::kInferences:
      return "inferences";
    case Limit::kDepth:
      return "depth";
    case Limit::kTime:
      return "time";
    case Limit::kCancelled:
      return "cancelled";
  }
  return "";
}

std::string_view Name(Assumption::State state) {
  switch (state) {
    case Assumption::State::kMade:
      return "made";
    case Assumption::State::kMadeByBound:
      return "made_by_bound";
    case Assumption::State::kRetracted:
      return "retracted";
  }
  return "";
}

}  // namespace latchwork::sdk

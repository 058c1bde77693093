// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_JSON_DIFFERENCE_H_
#define LATCHWORK_RECORD_JSON_DIFFERENCE_H_

#include <optional>
#include <string>
#include <string_view>

namespace latchwork::record {

/// Where two frames differ first, in the words of a person.
struct FrameDifference {
  std::string place;
  std::string recorded;
  std::string now;
};

/// Fields are compared in the order in which they come about in a tick. Nothing when they agree.
std::optional<FrameDifference> FindDifference(std::string_view recorded, std::string_view now);

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_JSON_DIFFERENCE_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_FRAME_ROWS_H_
#define LATCHWORK_RECORD_FRAME_ROWS_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace latchwork::record {

/// One value of a frame and where it stands, in the words of a person: "layer avoid, conclusion 1",
/// "turn(0.21)".
struct FrameRow {
  std::string place;
  std::string value;
  friend bool operator==(const FrameRow&, const FrameRow&) = default;
};

/// The values of a frame in the order in which they came about. The JSON has at most kMaxNesting
/// levels; what is no JSON gives one row.
std::vector<FrameRow> FrameRows(std::string_view json);

/// Where two frames differ first, in the words of a person.
struct FrameDifference {
  std::string place;
  std::string recorded;
  std::string now;
};

/// Nothing when the frames hold the same values.
std::optional<FrameDifference> FindDifference(std::string_view recorded, std::string_view now);

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_FRAME_ROWS_H_

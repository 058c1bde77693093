// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_FRAME_H_
#define LATCHWORK_RECORD_FRAME_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace latchwork::record {

/// A longer frame is neither written nor read: it bounds a reader's memory.
inline constexpr std::size_t kMaxFrameBytes = std::size_t{16} << 20U;
/// Deeper lists and objects are neither written nor read.
inline constexpr std::size_t kMaxNesting = 16;
/// `LLLLLLLL HHHHHHHHHHHHHHHH `: length of the JSON and checksum, hexadecimal.
inline constexpr std::size_t kFramePrefix = 26;

/// Appends prefix, JSON and a line feed to `out`.
void AppendFrame(std::string_view json, std::uint64_t checksum, std::string& out);

struct FramePrefix {
  std::size_t length = 0;
  std::uint64_t checksum = 0;
};

/// `bytes` are kFramePrefix bytes; nothing when they are no prefix or announce too long a frame.
std::optional<FramePrefix> ParseFramePrefix(std::string_view bytes);

/// Whether `json` is JSON that recursion may walk through.
bool IsShallowJson(std::string_view json);

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_FRAME_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_FRAME_H_
#define LATCHWORK_RECORD_FRAME_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace latchwork::record {

/// Where the chains of hashes start (the offset basis of FNV-1a, 64 bits).
inline constexpr std::uint64_t kChainStart = 0xcbf29ce484222325ULL;

/// FNV-1a over `text`, continuing from `chain`.
std::uint64_t Chain(std::uint64_t chain, std::string_view text);

/// Appends `LLLLLLLL HHHHHHHHHHHHHHHH json\n` (length of the JSON and hash, hexadecimal) to `out`.
void AppendFrame(std::string_view json, std::uint64_t hash, std::string& out);

struct Frame {
  std::string_view json;
  std::uint64_t hash = 0;  ///< As written; checking it is the reader's business.
  std::size_t size = 0;    ///< Of the whole frame.
};

/// The frame at the start of `bytes`; nothing when there is no whole one.
std::optional<Frame> ParseFrame(std::string_view bytes);

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_FRAME_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_MAP_IMAGE_H_
#define LATCHWORK_OFFICE_MAP_IMAGE_H_

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace latchwork::office {

inline constexpr std::uint64_t kMaxSide = 20000;
inline constexpr std::uint64_t kMaxCells = 64U << 20U;

/// Empty, or why a map of this many cells is refused. `name` begins the message.
std::string CheckMapSize(std::uint64_t width, std::uint64_t height, const std::string& name);

/// An 8-bit grey picture, row by row from its lower edge, or what is wrong with the file.
struct LoadedImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> grey;
  std::string error;
};

/// Reads a PNG (through MRPT, after its chunks and checksums were checked) or a binary or plain
/// PGM.
LoadedImage LoadImage(const std::filesystem::path& file);

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_MAP_IMAGE_H_

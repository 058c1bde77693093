// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGIN_PLUGIN_INFO_READER_H_
#define LATCHWORK_PLUGIN_PLUGIN_INFO_READER_H_

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "latchwork/sdk/plugin.h"

namespace latchwork::plugin {

/// The record of a plugin as it stands in its file, or why there is none ("is truncated: …").
/// A record shorter than this build's is filled up with zero bytes; its `size` tells.
struct PluginInfoReading {
  std::optional<sdk::PluginInfo> info;
  std::string problem;
};

/// Reads the record from the section `.latchwork` of an ELF64 file, without running anything of
/// it. Works on stripped files. Every byte of the file may be wrong: what is read is bounded.
PluginInfoReading ReadPluginInfo(const std::filesystem::path& file);
PluginInfoReading ReadPluginInfo(std::span<const std::byte> image);

/// A text of a record up to its zero byte, with '?' for what is not printable ASCII.
std::string TextOf(std::span<const char> text);

}  // namespace latchwork::plugin

#endif  // LATCHWORK_PLUGIN_PLUGIN_INFO_READER_H_

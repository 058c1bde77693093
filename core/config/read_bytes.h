// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONFIG_READ_BYTES_H_
#define LATCHWORK_CONFIG_READ_BYTES_H_

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "latchwork/logic/diagnostic.h"

namespace latchwork::config {

/// The bytes of a regular file, or nothing and why not.
std::optional<std::string> ReadBytes(const std::filesystem::path& file, std::size_t limit,
                                     logic::Diagnostics& diagnostics);

/// What keeps these bytes from being the XML text that is read here: they are empty, too many,
/// UTF-16, binary or not UTF-8. Nothing when all is well.
std::optional<logic::Diagnostic> CheckText(std::string_view bytes, std::string_view name,
                                           std::size_t limit);

/// The UTF-8 byte order mark, which CheckText allows at the start.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

}  // namespace latchwork::config

#endif  // LATCHWORK_CONFIG_READ_BYTES_H_

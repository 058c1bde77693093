// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONFIG_DURATION_H_
#define LATCHWORK_CONFIG_DURATION_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace latchwork::config {

/// "100ms", "1.5s", "2min" in microseconds; nothing when the text is no duration of whole
/// microseconds with at most nine digits before the point. Units: us, ms, s, min, h.
std::optional<std::uint64_t> ParseDuration(std::string_view text);

/// In the largest of s, ms and us in which it is a whole number: "1500ms".
std::string FormatDuration(std::uint64_t microseconds);

}  // namespace latchwork::config

#endif  // LATCHWORK_CONFIG_DURATION_H_

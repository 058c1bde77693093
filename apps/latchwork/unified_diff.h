// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_UNIFIED_DIFF_H_
#define LATCHWORK_APPS_LATCHWORK_UNIFIED_DIFF_H_

#include <string>
#include <string_view>

namespace latchwork::app {

/// What turns one text into another, as `diff -u` prints it and `patch` reads it; empty where they
/// are the same.
std::string UnifiedDiff(std::string_view before, std::string_view after, const std::string& file);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_UNIFIED_DIFF_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_MARKUP_H_
#define LATCHWORK_SDK_MARKUP_H_

#include <string>
#include <string_view>

namespace latchwork::sdk {

/// A text as it stands between the tags and in the attributes of SVG and HTML. Control characters,
/// which XML cannot hold at all, become spaces.
std::string Escaped(std::string_view text);

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_MARKUP_H_

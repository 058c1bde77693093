// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_UTF8_H_
#define LATCHWORK_LOGIC_UTF8_H_

#include <cstddef>
#include <string_view>

namespace latchwork::logic {

/// Bytes of the UTF-8 character that `text` begins with; 0 when it begins with none.
std::size_t Utf8Length(std::string_view text);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_UTF8_H_

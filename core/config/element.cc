// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "latchwork/config/xml.h"

namespace latchwork::config {

const Attribute* Element::Find(std::string_view attribute) const {
  const auto found = std::ranges::find(attributes, attribute, &Attribute::name);
  return found == attributes.end() ? nullptr : &*found;
}

}  // namespace latchwork::config

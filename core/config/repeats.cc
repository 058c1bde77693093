// SPDX-License-Identifier: BSD-3-Clause
#include "core/config/repeats.h"

#include <fmt/format.h>

#include <map>
#include <string>

namespace latchwork::config {

void CheckRepeats(const Element& element, logic::Diagnostics& diagnostics) {
  std::map<std::string, const Element*> seen;
  for (const Element& child : element.children) {
    CheckRepeats(child, diagnostics);
    std::string what;
    if (child.name == "reasoner" || child.name == "fallback") {
      what = fmt::format("<{}>", child.name);
    }
    const Attribute* name = child.Find("name");
    if (child.name == "param" && name != nullptr) what = fmt::format("parameter '{}'", name->value);
    if (what.empty()) continue;
    const auto [first, is_new] = seen.emplace(what, &child);
    if (is_new) continue;
    diagnostics.push_back({child.place,
                           fmt::format("{} stands twice in this <{}>", what, element.name),
                           fmt::format("the first is in line {}", first->second->place.line), ""});
  }
}

}  // namespace latchwork::config

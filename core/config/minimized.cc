// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/config/agent_check.h"

namespace latchwork::config {
namespace {

std::optional<logic::PredicateName> ReadName(AgentCheck& check, const Attribute& attribute) {
  const std::string_view text = attribute.value;
  const std::size_t slash = text.rfind('/');
  const std::string_view digits = slash == std::string_view::npos ? "" : text.substr(slash + 1);
  std::uint8_t arity = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), arity);
  const bool is_number = error == std::errc() && stop == digits.data() + digits.size();
  if (is_number && slash > 0) {
    return logic::PredicateName{check.symbols.Intern(text.substr(0, slash)), arity};
  }
  check.Say(attribute.place,
            fmt::format("'{}' does not name a predicate with its number of arguments", text),
            slash == std::string_view::npos ? fmt::format("write it as {}/0 or {}/1", text, text)
                                            : "write it as name/number");
  return std::nullopt;
}

}  // namespace

void CheckMinimized(AgentCheck& check, const Element& layer, LayerDescription& description) {
  for (const Element& child : layer.children) {
    const Attribute* predicate = child.Find("predicate");
    if (child.name != "minimize" || predicate == nullptr) continue;
    const auto name = ReadName(check, *predicate);
    if (!name) continue;
    sdk::Minimized minimized{*name, 0};
    if (const Attribute* depth = child.Find("depth")) {
      const char* const end = depth->value.data() + depth->value.size();
      std::from_chars(depth->value.data(), end, minimized.depth);
    }
    if (std::ranges::find(description.minimized, *name, &sdk::Minimized::predicate) !=
        description.minimized.end()) {
      check.Say(predicate->place, fmt::format("'{}' is minimized twice", predicate->value));
      continue;
    }
    description.minimized.push_back(minimized);
  }
}

}  // namespace latchwork::config

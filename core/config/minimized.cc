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

std::uint32_t ReadNumber(const Element& element, std::string_view name, std::uint32_t otherwise) {
  const Attribute* const attribute = element.Find(name);
  if (attribute == nullptr) return otherwise;
  const char* const end = attribute->value.data() + attribute->value.size();
  std::from_chars(attribute->value.data(), end, otherwise);
  return otherwise;
}

void Take(const Element& element, const logic::PredicateName& name, LayerDescription& description) {
  if (element.name == "minimize") {
    description.minimized.push_back(
        {name, ReadNumber(element, "depth", 0), ReadNumber(element, "priority", 1)});
  } else {
    (element.name == "vary" ? description.varied : description.fixed).push_back(name);
  }
}

}  // namespace

void CheckMinimized(AgentCheck& check, const Element& layer, LayerDescription& description) {
  struct Role {
    logic::PredicateName name;
    std::string_view role;
  };
  std::vector<Role> roles;
  for (const Element& child : layer.children) {
    const Attribute* predicate = child.Find("predicate");
    if (predicate == nullptr) continue;
    const auto name = ReadName(check, *predicate);
    if (!name) continue;
    const auto known = std::ranges::find(roles, *name, &Role::name);
    if (known == roles.end()) {
      roles.push_back({*name, child.name});
      Take(child, *name, description);
      continue;
    }
    check.Say(predicate->place,
              known->role == child.name
                  ? fmt::format("<{}> names '{}' twice", child.name, predicate->value)
                  : fmt::format("'{}' stands in <{}> and in <{}>", predicate->value, known->role,
                                child.name),
              known->role == child.name ? "" : "a predicate is minimized, fixed, or varies");
  }
}

}  // namespace latchwork::config

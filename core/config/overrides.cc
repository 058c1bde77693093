// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "core/config/agent_check.h"

namespace latchwork::config {
namespace {

bool IsPart(const Element& element, std::string_view name) {
  if (element.name == "world") return name == "world";
  const Attribute* own = element.Find("name");
  return element.name == "layer" && own != nullptr && own->value == name;
}

Element* FindPartElement(std::vector<Element>& elements, std::string_view name) {
  const auto found =
      std::ranges::find_if(elements, [&](const Element& e) { return IsPart(e, name); });
  return found == elements.end() ? nullptr : &*found;
}

std::vector<std::string> PartNames(const std::vector<Element>& elements) {
  std::vector<std::string> names = {"world"};
  for (const Element& element : elements) {
    const Attribute* name = element.Find("name");
    if (element.name == "layer" && name != nullptr) names.push_back(name->value);
  }
  return names;
}

Element* FindChild(Element& element, std::string_view name) {
  const auto found = std::ranges::find(element.children, name, &Element::name);
  return found == element.children.end() ? nullptr : &*found;
}

void SetAttribute(Element& element, const Attribute& attribute) {
  std::erase_if(element.attributes, [&](const Attribute& a) { return a.name == attribute.name; });
  element.attributes.push_back(attribute);
}

/// Another plugin starts with none of the old one's parameters.
void MergeReasoner(Element& layer, const Element& given) {
  Element* reasoner = FindChild(layer, "reasoner");
  if (reasoner == nullptr) {
    layer.children.push_back(given);
    return;
  }
  const Attribute* old_plugin = reasoner->Find("plugin");
  const Attribute* new_plugin = given.Find("plugin");
  if (new_plugin != nullptr && (old_plugin == nullptr || old_plugin->value != new_plugin->value)) {
    reasoner->children.clear();
    reasoner->place = given.place;
  }
  for (const Attribute& attribute : given.attributes) SetAttribute(*reasoner, attribute);
  for (const Element& child : given.children) reasoner->children.push_back(child);
}

void MergeIntoLayer(Element& layer, const Element& given) {
  for (const Attribute& attribute : given.attributes) {
    if (attribute.name != "part") SetAttribute(layer, attribute);
  }
  std::set<std::string> replaced;
  for (const Element& child : given.children) {
    if (child.name == "reasoner") {
      MergeReasoner(layer, child);
      continue;
    }
    if (child.name != "param" && replaced.insert(child.name).second) {
      std::erase_if(layer.children, [&](const Element& e) { return e.name == child.name; });
    }
    layer.children.push_back(child);
  }
}

void MergeIntoWorld(AgentCheck& check, Element& world, const Element& given) {
  for (const Attribute& attribute : given.attributes) {
    if (attribute.name == "period" || attribute.name == "phase" || attribute.name == "latency") {
      check.Say(attribute.name_place, fmt::format("the world has no {}", attribute.name),
                "it takes <param> only");
    }
  }
  for (const Element& child : given.children) {
    if (child.name == "param") {
      world.children.push_back(child);
    } else {
      check.Say(child.place, fmt::format("the world has no <{}>", child.name),
                "it takes <param> only");
    }
  }
}

void Merge(AgentCheck& check, std::vector<Element>& elements, const Element& given,
           const logic::SourcePlace& place, std::string_view name) {
  Element* part = FindPartElement(elements, name);
  if (part == nullptr) {
    if (!check.is_whole) return;
    check.Say(place, fmt::format("there is no part '{}' to override", name),
              NameHint(name, PartNames(elements)));
  } else if (part->name == "world") {
    MergeIntoWorld(check, *part, given);
  } else {
    MergeIntoLayer(*part, given);
  }
}

constexpr std::string_view kReasonerSuffix = ".reasoner";

bool IsBudget(std::string_view name) { return name == "inferences" || name == "depth"; }

bool IsPositiveInteger(std::string_view text, std::size_t digits) {
  return !text.empty() && text.size() <= digits && text.front() != '0' &&
         text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// --set part.name=value as the <override> that it stands for.
std::optional<Element> AsElement(AgentCheck& check, const Override& override,
                                 const logic::SourcePlace& place) {
  const bool is_reasoner = override.part.ends_with(kReasonerSuffix);
  Element result{"override", {}, {}, "", place};
  Element reasoner{"reasoner", {}, {}, "", place};
  Element param{"param",
                {{"name", override.name, place, place}, {"value", override.value, place, place}},
                {},
                "",
                place};
  if (is_reasoner && IsBudget(override.name)) {
    if (!IsPositiveInteger(override.value, override.name == "depth" ? 9 : 18)) {
      check.Say(place, fmt::format("{}.{} must be a positive integer, not '{}'", override.part,
                                   override.name, override.value));
      return std::nullopt;
    }
    reasoner.attributes.push_back({override.name, override.value, place, place});
    result.children.push_back(std::move(reasoner));
  } else if (is_reasoner) {
    reasoner.children.push_back(std::move(param));
    result.children.push_back(std::move(reasoner));
  } else {
    result.children.push_back(std::move(param));
  }
  return result;
}

std::string_view PartOf(const Override& override) {
  std::string_view part = override.part;
  if (part.ends_with(kReasonerSuffix)) part.remove_suffix(kReasonerSuffix.size());
  return part;
}

}  // namespace

void ApplyOverrides(AgentCheck& check, std::vector<Element>& elements,
                    const std::vector<Override>& overrides) {
  std::vector<Element> given;
  for (Element& element : elements) {
    if (element.name == "override") given.push_back(element);
  }
  for (const Element& element : given) {
    const Attribute* part = element.Find("part");
    if (part != nullptr && !check.HasEnough()) {
      Merge(check, elements, element, part->place, part->value);
    }
  }
  const logic::SourcePlace place{"command line", 0, 0};
  for (const Override& override : overrides) {
    if (const auto element = AsElement(check, override, place)) {
      Merge(check, elements, *element, place, PartOf(override));
    }
  }
}

}  // namespace latchwork::config

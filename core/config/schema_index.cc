// SPDX-License-Identifier: BSD-3-Clause
#include "core/config/schema_index.h"

#include <string_view>

namespace latchwork::config {
namespace {

/// Schema elements carry their namespace: {...XMLSchema}element.
bool Is(const Element& element, std::string_view name) {
  return element.name.ends_with("}" + std::string(name));
}

std::string ValueOf(const Element& element, std::string_view attribute) {
  const Attribute* found = element.Find(attribute);
  return found == nullptr ? std::string() : found->value;
}

void AddContent(const Element& element, ElementType& type) {
  for (const Element& child : element.children) {
    if (Is(child, "element")) {
      type.children[ValueOf(child, "name")] = ValueOf(child, "type");
    } else if (Is(child, "attribute")) {
      type.attributes[ValueOf(child, "name")] = {ValueOf(child, "type"),
                                                 ValueOf(child, "use") == "required"};
    } else {
      AddContent(child, type);
    }
  }
}

void AddFacets(const Element& element, ValueType& type) {
  if (Is(element, "pattern")) type.pattern = ValueOf(element, "value");
  if (Is(element, "documentation")) type.help = element.text;
  for (const Element& child : element.children) AddFacets(child, type);
}

}  // namespace

SchemaIndex IndexSchema(const Element& schema) {
  SchemaIndex index;
  for (const Element& child : schema.children) {
    const std::string name = ValueOf(child, "name");
    if (Is(child, "element")) index.roots[name] = ValueOf(child, "type");
    if (Is(child, "complexType")) {
      AddContent(child, index.elements[name]);
      index.elements[name].text = ValueOf(child, "mixed") == "true";
    }
    if (Is(child, "simpleType")) AddFacets(child, index.values[name]);
  }
  return index;
}

}  // namespace latchwork::config

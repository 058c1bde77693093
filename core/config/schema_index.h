// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONFIG_SCHEMA_INDEX_H_
#define LATCHWORK_CONFIG_SCHEMA_INDEX_H_

#include <map>
#include <string>
#include <vector>

#include "latchwork/config/xml.h"

namespace latchwork::config {

/// What may stand in an element, as the schema says.
struct ElementType {
  struct AttributeType {
    std::string type;
    bool required = false;
  };
  std::map<std::string, std::string> children;  ///< Name to type.
  std::map<std::string, AttributeType> attributes;
  bool text = false;
};

struct ValueType {
  std::string pattern;
  std::string help;  ///< Its documentation: "a duration (...)".
};

/// The part of an XSD that is needed to explain in words what is wrong: named types, local elements
/// in a choice, simple types that are patterns.
struct SchemaIndex {
  std::map<std::string, std::string> roots;  ///< Name to type.
  std::map<std::string, ElementType> elements;
  std::map<std::string, ValueType> values;
};

/// `schema` is the root of the XSD.
SchemaIndex IndexSchema(const Element& schema);

/// The keys of a map, in order.
template <typename Map>
std::vector<std::string> KeysOf(const Map& map) {
  std::vector<std::string> keys;
  keys.reserve(map.size());
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

}  // namespace latchwork::config

#endif  // LATCHWORK_CONFIG_SCHEMA_INDEX_H_

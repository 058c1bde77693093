// SPDX-License-Identifier: BSD-3-Clause
#include "core/record/json_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/record/tick_encoder.h"

namespace latchwork::record {
namespace {

constexpr std::size_t kMostNested = 16;

using Difference = std::optional<FrameDifference>;

std::string Show(const Json* value) {
  if (value == nullptr) return "(nothing)";
  if (value->is_string()) return value->get<std::string>();
  if (value->is_object() && value->contains("fact") && (*value)["fact"].is_string()) {
    return (*value)["fact"].get<std::string>();
  }
  if (value->is_structured()) return fmt::format("{} entries", value->size());
  return Dump(*value);
}

const Json* Member(const Json& object, const std::string& name) {
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

/// The members of a tick come about in a fixed order, the missing ones as well.
std::vector<std::string> Members(const Json& a, const Json& b) {
  std::vector<std::string> names;
  if (a.contains("tick") || b.contains("tick")) {
    names = {"tick",      "events",    "sensed",   "latched", "refused",
             "decisions", "inhibited", "commands", "faults"};
  }
  for (const Json* object : {&a, &b}) {
    for (const auto& [name, value] : object->items()) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

std::string Label(const Json& element, const std::string& place, std::size_t index) {
  const Json* layer = element.is_object() ? Member(element, "layer") : nullptr;
  if (layer == nullptr || !layer->is_string()) return fmt::format("{}[{}]", place, index);
  std::string label = "layer " + layer->get<std::string>();
  if (const Json* latch = Member(element, "latch")) label += ", latch " + Show(latch);
  if (place == "faults") label += ", fault";
  return label;
}

std::string Child(const std::string& place, const std::string& name) {
  if (place.empty()) return name;
  if (place == "sensed") return "sensor " + name;
  if (place == "commands") return "effector " + name;
  if (name == "fact") return place;
  return place + (place.starts_with("layer ") && !place.ends_with(']') ? ", " : " ") + name;
}

Difference Compare(const Json* a, const Json* b, const std::string& place, std::size_t depth);

Difference CompareArrays(const Json& a, const Json& b, const std::string& place,
                         std::size_t depth) {
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const Json* left = i < a.size() ? &a[i] : nullptr;
    const Json* right = i < b.size() ? &b[i] : nullptr;
    const std::string label = Label(left != nullptr ? *left : *right, place, i);
    if (auto found = Compare(left, right, label, depth + 1)) return found;
  }
  return std::nullopt;
}

Difference CompareObjects(const Json& a, const Json& b, const std::string& place,
                          std::size_t depth) {
  for (const std::string& name : Members(a, b)) {
    const std::string label = Child(place, name);
    if (auto found = Compare(Member(a, name), Member(b, name), label, depth + 1)) return found;
  }
  return std::nullopt;
}

Difference Compare(const Json* a, const Json* b, const std::string& place, std::size_t depth) {
  if (a == nullptr && b == nullptr) return std::nullopt;
  const Json& left = a != nullptr ? *a : *b;
  const Json& right = b != nullptr ? *b : *a;
  const bool one_is_missing = a == nullptr || b == nullptr;
  if (!one_is_missing && left == right) return std::nullopt;
  if (left.is_structured() && left.type() == right.type() && depth < kMostNested) {
    // What is missing is compared with nothing, so that its first entry is named.
    const Json nothing(left.type());
    const Json& from = a != nullptr ? *a : nothing;
    const Json& to = b != nullptr ? *b : nothing;
    auto found = left.is_array() ? CompareArrays(from, to, place, depth)
                                 : CompareObjects(from, to, place, depth);
    if (found) return found;
  }
  return FrameDifference{place, Show(a), Show(b)};
}

}  // namespace

std::optional<FrameDifference> FindDifference(std::string_view recorded, std::string_view now) {
  if (recorded == now) return std::nullopt;
  const Json left = Json::parse(recorded, nullptr, false);
  const Json right = Json::parse(now, nullptr, false);
  if (left.is_discarded()) return FrameDifference{"frame", "text that is not JSON", "JSON"};
  if (auto found = Compare(&left, &right, "", 0)) return found;
  return FrameDifference{"frame", "other spelling", "the same values"};
}

}  // namespace latchwork::record

// SPDX-License-Identifier: BSD-3-Clause
#include "core/record/frame_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

namespace latchwork::record {
namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<FrameRow>;

constexpr std::string_view kNothing = "nothing";

/// What members are called in a place; others keep their names.
constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kWords = {{
    {"events", "event"},
    {"sensed", "sensor"},
    {"latched", ""},
    {"refused", "refused for"},
    {"decisions", ""},
    {"commands", "command"},
    {"faults", "fault"},
    {"fact", ""},
    {"facts", "fact"},
    {"conclusions", "conclusion"},
    {"assumptions", "assumption"},
    {"rests_on", "rests on"},
    {"attachment_calls", "attachment calls"},
    {"made_by_bound", "made by bound"},
}};

std::string Word(const std::string& member) {
  const auto* const found = std::find_if(kWords.begin(), kWords.end(),
                                         [&](const auto& word) { return word.first == member; });
  return found == kWords.end() ? member : std::string(found->second);
}

std::string Join(const std::string& place, const std::string& word) {
  if (place.empty() || word.empty()) return place + word;
  return place + " " + word;
}

std::string Show(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void Walk(const Json& value, const std::string& place, Rows& rows) {
  if (value.is_object()) {
    for (const auto& [name, member] : value.items()) Walk(member, Join(place, Word(name)), rows);
  } else if (value.is_array()) {
    if (value.empty()) rows.push_back({place, "none"});
    std::size_t number = 0;
    for (const Json& element : value) Walk(element, fmt::format("{} {}", place, ++number), rows);
  } else {
    rows.push_back({place, Show(value)});
  }
}

/// An entry that says in its members where it belongs.
void WalkEntry(Json entry, const std::string& section, Rows& rows) {
  if (!entry.is_object()) return Walk(entry, section, rows);
  const auto take = [&](const char* member) {
    const auto found = entry.find(member);
    if (found == entry.end()) return std::string();
    std::string text = Show(*found);
    entry.erase(found);
    return text;
  };
  const std::string layer = take("layer");
  std::string place = Join(layer.empty() ? "world," : "layer " + layer + ",", Word(section));
  for (const char* member : {"latch", "effector"}) {
    if (const std::string name = take(member); !name.empty()) {
      place = Join(place, fmt::format("{} {}", member, name));
    }
  }
  Walk(entry, place, rows);
}

void WalkSection(const std::string& section, const Json& content, Rows& rows) {
  if (section == "tick") return;
  if (section == "sensed" || section == "commands") {
    for (const auto& [name, facts] : content.items()) {
      Walk(facts, fmt::format("{} {}, fact", Word(section), name), rows);
    }
  } else if (section == "events" || section == "end" || !content.is_array()) {
    Walk(content, Word(section), rows);
  } else {
    for (const Json& entry : content) WalkEntry(entry, section, rows);
  }
}

bool HasPlace(const Rows& rows, std::size_t from, const std::string& place) {
  return std::any_of(rows.begin() + static_cast<std::ptrdiff_t>(from), rows.end(),
                     [&](const FrameRow& row) { return row.place == place; });
}

FrameDifference OnlyThen(const FrameRow& row) {
  return {row.place, row.value, std::string(kNothing)};
}
FrameDifference OnlyNow(const FrameRow& row) {
  return {row.place, std::string(kNothing), row.value};
}

}  // namespace

std::vector<FrameRow> FrameRows(std::string_view json) {
  Rows rows;
  const Json frame = Json::parse(json, nullptr, false);
  if (!frame.is_object()) return {{"frame", "no JSON object"}};
  for (const auto& [section, content] : frame.items()) WalkSection(section, content, rows);
  return rows;
}

std::optional<FrameDifference> FindDifference(std::string_view recorded, std::string_view now) {
  if (recorded == now) return std::nullopt;
  const Rows a = FrameRows(recorded);
  const Rows b = FrameRows(now);
  const std::size_t common = std::min(a.size(), b.size());
  std::size_t i = 0;
  while (i < common && a[i] == b[i]) ++i;
  if (i == a.size() && i == b.size()) return std::nullopt;
  if (i == a.size()) return OnlyNow(b[i]);
  if (i == b.size()) return OnlyThen(a[i]);
  if (a[i].place == b[i].place) return FrameDifference{a[i].place, a[i].value, b[i].value};
  // What one of them lacks comes first; the other's row follows further down.
  return HasPlace(b, i, a[i].place) ? OnlyNow(b[i]) : OnlyThen(a[i]);
}

}  // namespace latchwork::record

// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/making.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace latchwork::office {

void Making::Fail(std::string_view parameter, std::string message, std::string hint) {
  diagnostics.push_back({parameters.PlaceOf(parameter), std::move(message), std::move(hint), {}});
}

void Making::FailName(std::string_view parameter, std::string_view kind, std::string_view name,
                      const std::vector<std::string>& known) {
  const auto near = logic::NearestName(name, known);
  Fail(parameter, "the building has no " + std::string(kind) + " '" + std::string(name) + "'",
       near.empty() ? std::string() : "did you mean '" + std::string(near) + "'?");
}

std::vector<std::string_view> Words(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> words;
  while (true) {
    const auto first = text.find_first_not_of(separators);
    if (first == std::string_view::npos) return words;
    text.remove_prefix(first);
    const auto end = std::min(text.size(), text.find_first_of(separators));
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

std::optional<double> Number(std::string_view text) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = code == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace latchwork::office

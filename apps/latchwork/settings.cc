// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/settings.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string_view>

namespace latchwork::app {
namespace {

std::optional<config::Override> ParseSetting(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  const std::size_t dot = text.substr(0, equals).rfind('.');
  if (dot == std::string_view::npos || dot == 0 || dot + 1 == equals) return std::nullopt;
  return config::Override{std::string(text.substr(0, dot)),
                          std::string(text.substr(dot + 1, equals - dot - 1)),
                          std::string(text.substr(equals + 1))};
}

}  // namespace

std::vector<config::Override> ParseSettings(const std::vector<std::string>& settings) {
  std::vector<config::Override> overrides;
  for (const std::string& setting : settings) {
    const std::optional<config::Override> parsed = ParseSetting(setting);
    if (!parsed) {
      throw CLI::ValidationError("--set",
                                 "'" + setting + "' is not PART.NAME=VALUE, as in world.people=4");
    }
    overrides.push_back(*parsed);
  }
  return overrides;
}

}  // namespace latchwork::app

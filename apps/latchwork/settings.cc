// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/settings.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

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

CLI::Validator WholeNumber(std::uint64_t least, std::uint64_t most) {
  const auto problem = [least, most](const std::string& text) -> std::string {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_number = !text.empty() && end == text.data() + text.size();
    if (is_number && error == std::errc() && number >= least && number <= most) return "";
    if (most == std::numeric_limits<std::uint64_t>::max() && error == std::errc()) {
      return fmt::format("'{}' is not a whole number, {} or more", text, least);
    }
    return fmt::format("'{}' is not a whole number from {} to {}", text, least, most);
  };
  return CLI::Validator(problem, "");
}

CLI::Validator NotEmpty() {
  const auto problem = [](const std::string& text) -> std::string {
    return text.empty() ? "the name is empty" : "";
  };
  return CLI::Validator(problem, "");
}

}  // namespace latchwork::app

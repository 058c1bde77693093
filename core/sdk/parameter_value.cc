// SPDX-License-Identifier: BSD-3-Clause
#include "core/sdk/parameter_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>

namespace latchwork::sdk {
namespace {

template <typename Number>
std::optional<Number> ParseNumber(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

bool InRange(const ParameterSpec& spec, double value) {
  return std::isfinite(value) && value >= spec.minimum && value <= spec.maximum;
}

std::optional<Parameters::Value> ParseInteger(const ParameterSpec& spec, std::string_view text) {
  const auto value = ParseNumber<std::int64_t>(text);
  if (!value || !InRange(spec, static_cast<double>(*value))) return std::nullopt;
  return *value;
}

std::optional<Parameters::Value> ParseReal(const ParameterSpec& spec, std::string_view text) {
  const auto value = ParseNumber<double>(text);
  if (!value || !InRange(spec, *value)) return std::nullopt;
  return *value;
}

std::optional<Parameters::Value> ParseBoolean(std::string_view text) {
  if (text == "true") return true;
  if (text == "false") return false;
  return std::nullopt;
}

std::optional<Parameters::Value> ParseText(const ParameterSpec& spec, std::string_view text) {
  const auto& choices = spec.choices;
  if (!choices.empty() && std::find(choices.begin(), choices.end(), text) == choices.end()) {
    return std::nullopt;
  }
  return std::string(text);
}

std::string AllowedNumber(const ParameterSpec& spec, std::string_view kind) {
  std::string result(kind);
  const bool has_minimum = std::isfinite(spec.minimum);
  const bool has_maximum = std::isfinite(spec.maximum);
  if (has_minimum && has_maximum) {
    result += fmt::format(" from {} to {}", spec.minimum, spec.maximum);
  } else if (has_minimum) {
    result += fmt::format(" not below {}", spec.minimum);
  } else if (has_maximum) {
    result += fmt::format(" not above {}", spec.maximum);
  }
  if (!spec.unit.empty()) result += fmt::format(" ({})", spec.unit);
  return result;
}

std::string AllowedText(const ParameterSpec& spec) {
  if (spec.choices.empty()) return "a text";
  std::string result;
  for (std::size_t i = 0; i < spec.choices.size(); ++i) {
    if (i > 0) result += i + 1 == spec.choices.size() ? " or " : ", ";
    result += fmt::format("'{}'", spec.choices[i]);
  }
  return result;
}

}  // namespace

std::optional<Parameters::Value> ParseParameter(const ParameterSpec& spec, std::string_view text) {
  switch (spec.type) {
    case ParameterType::kInteger:
      return ParseInteger(spec, text);
    case ParameterType::kReal:
      return ParseReal(spec, text);
    case ParameterType::kBoolean:
      return ParseBoolean(text);
    case ParameterType::kText:
      return ParseText(spec, text);
    case ParameterType::kFile:
      return std::string(text);
  }
  return std::nullopt;
}

std::string Allowed(const ParameterSpec& spec) {
  switch (spec.type) {
    case ParameterType::kInteger:
      return AllowedNumber(spec, "an integer");
    case ParameterType::kReal:
      return AllowedNumber(spec, "a number");
    case ParameterType::kBoolean:
      return "'true' or 'false'";
    case ParameterType::kText:
      return AllowedText(spec);
    case ParameterType::kFile:
      return "the path of a file";
  }
  return "";
}

Parameters::Value NoValue(ParameterType type) {
  switch (type) {
    case ParameterType::kInteger:
      return std::int64_t{0};
    case ParameterType::kReal:
      return 0.0;
    case ParameterType::kBoolean:
      return false;
    case ParameterType::kText:
    case ParameterType::kFile:
      break;
  }
  return std::string();
}

}  // namespace latchwork::sdk

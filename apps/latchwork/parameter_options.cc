// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/parameter_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "latchwork/logic/diagnostic.h"

namespace latchwork::app {
namespace {

std::string Dashed(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::string WithUnit(std::string text, const sdk::ParameterSpec& spec) {
  return spec.unit.empty() ? text : text + " " + spec.unit;
}

std::string Help(const sdk::ParameterSpec& spec) {
  std::string text = spec.help;
  if (!text.empty() && spec.type != sdk::ParameterType::kBoolean) {
    if (std::isfinite(spec.minimum) && std::isfinite(spec.maximum)) {
      text +=
          fmt::format("; {} to {}", spec.minimum, WithUnit(fmt::format("{}", spec.maximum), spec));
    }
  }
  if (spec.default_value) text += fmt::format(" [{}]", WithUnit(*spec.default_value, spec));
  return text;
}

/// What is wrong with the value, or "".
std::string Complaint(const sdk::ParameterSpec& spec, const std::string& value) {
  logic::Diagnostics diagnostics;
  const sdk::Parameters::Given given{spec.name, value, {}};
  sdk::Parameters::Check({&spec, 1}, {&given, 1}, "the command", {}, diagnostics);
  if (diagnostics.empty()) return "";
  return diagnostics.front().message + " (" + diagnostics.front().hint + ")";
}

void AddSwitch(CLI::App& command, const sdk::ParameterSpec& spec,
               std::vector<sdk::Parameters::Given>& given) {
  const std::string name = Dashed(spec.name);
  command.add_flag_function(
      "--" + name + ",!--no-" + name,
      [&spec, &given](std::int64_t count) {
        given.push_back({spec.name, count > 0 ? "true" : "false", {}});
      },
      Help(spec));
}

void AddValue(CLI::App& command, const std::string& names, const sdk::ParameterSpec& spec,
              std::vector<sdk::Parameters::Given>& given) {
  CLI::Option* const option = command.add_option_function<std::string>(
      names,
      [&spec, &given](const std::string& value) {
        given.push_back({spec.name, value, {}});
      },
      Help(spec));
  option->check([&spec](const std::string& value) { return Complaint(spec, value); });
  option->type_name(spec.type == sdk::ParameterType::kText ? "NAME" : "NUMBER");
}

}  // namespace

void AddParameterOptions(CLI::App& command, std::span<const sdk::ParameterSpec> table,
                         std::vector<sdk::Parameters::Given>& given,
                         const std::map<std::string, std::string>& aliases) {
  for (const sdk::ParameterSpec& spec : table) {
    if (spec.type == sdk::ParameterType::kBoolean) {
      AddSwitch(command, spec, given);
    } else {
      const auto alias = aliases.find(spec.name);
      const std::string also = alias == aliases.end() ? "" : ",--" + alias->second;
      AddValue(command, "--" + Dashed(spec.name) + also, spec, given);
    }
  }
}

sdk::Parameters Values(std::span<const sdk::ParameterSpec> table,
                       std::span<const sdk::Parameters::Given> given) {
  logic::Diagnostics diagnostics;
  sdk::Parameters values = sdk::Parameters::Check(table, given, "the command", {}, diagnostics);
  if (!diagnostics.empty()) throw CLI::ValidationError(diagnostics.front().message);
  return values;
}

}  // namespace latchwork::app

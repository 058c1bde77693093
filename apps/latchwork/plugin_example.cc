// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/plugin_example.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace latchwork::app {
namespace {

std::string Escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// A value that the parameter's type allows.
std::string SampleValue(const sdk::ParameterSpec& parameter) {
  if (parameter.default_value) return *parameter.default_value;
  switch (parameter.type) {
    case sdk::ParameterType::kInteger:
    case sdk::ParameterType::kReal:
      return fmt::format("{}", std::isfinite(parameter.minimum) ? parameter.minimum
                                                                : std::min(0.0, parameter.maximum));
    case sdk::ParameterType::kBoolean:
      return "true";
    case sdk::ParameterType::kText:
      return parameter.choices.empty() ? "text" : parameter.choices.front();
    case sdk::ParameterType::kFile:
      return "file";
  }
  return {};
}

/// The parameters that must be given; where there are none, the first one, to show how it is done.
std::string Parameters(std::span<const sdk::ParameterSpec> parameters, std::string_view indent) {
  std::string lines;
  const auto add = [&](const sdk::ParameterSpec& parameter) {
    lines += fmt::format("{}<param name=\"{}\" value=\"{}\"/>\n", indent, parameter.name,
                         Escaped(SampleValue(parameter)));
  };
  for (const sdk::ParameterSpec& parameter : parameters) {
    if (!parameter.default_value) add(parameter);
  }
  if (lines.empty() && !parameters.empty()) add(parameters.front());
  return lines;
}

std::string Element(std::string_view start, std::string_view name, const std::string& content,
                    std::string_view indent) {
  if (content.empty()) return fmt::format("{}<{}/>\n", indent, start);
  return fmt::format("{0}<{1}>\n{2}{0}</{3}>\n", indent, start, content, name);
}

std::string Fragment(const std::string& content) {
  return "<fragment format=\"1\">\n" + content + "</fragment>\n";
}

}  // namespace

std::string WorldExample(std::string_view plugin, std::span<const sdk::ParameterSpec> parameters) {
  return Fragment(Element(fmt::format(R"(world plugin="{}")", plugin), "world",
                          Parameters(parameters, "    "), "  "));
}

std::string LayerExample(std::string_view plugin, const sdk::Contract& contract,
                         std::span<const sdk::ParameterSpec> parameters,
                         std::string_view reasoner) {
  std::string lines = Element(
      fmt::format(R"(layer name="{0}" plugin="{0}" period="100ms")", plugin), "layer",
      Parameters(parameters, "    ") + fmt::format("    <reasoner plugin=\"{}\"/>\n", reasoner),
      "  ");
  for (const sdk::PortSpec& port : contract.inputs) {
    lines += fmt::format("  <wire from=\"world.{0}\" to=\"{1}.{0}\" stale-after=\"300ms\"/>\n",
                         port.name, plugin);
  }
  for (const sdk::PortSpec& port : contract.outputs) {
    lines += fmt::format("  <wire from=\"{1}.{0}\" to=\"world.{0}\"/>\n", port.name, plugin);
  }
  return Fragment(lines);
}

std::string ReasonerExample(std::string_view plugin,
                            std::span<const sdk::ParameterSpec> parameters) {
  const std::string start =
      fmt::format(R"(reasoner plugin="{}" inferences="100000" depth="24")", plugin);
  return Fragment(Element(R"(override part="my_layer")", "override",
                          Element(start, "reasoner", Parameters(parameters, "      "), "    "),
                          "  "));
}

}  // namespace latchwork::app

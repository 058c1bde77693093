// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/plugin_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "apps/latchwork/plugin_example.h"

namespace latchwork::app {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string_view Word(sdk::ArgumentType type) {
  switch (type) {
    case sdk::ArgumentType::kInteger:
      return "integer";
    case sdk::ArgumentType::kReal:
      return "real";
    case sdk::ArgumentType::kSymbol:
      return "symbol";
    case sdk::ArgumentType::kAny:
      return "any";
  }
  return {};
}

std::string_view Word(sdk::ParameterType type) {
  switch (type) {
    case sdk::ParameterType::kInteger:
      return "integer";
    case sdk::ParameterType::kReal:
      return "real";
    case sdk::ParameterType::kBoolean:
      return "boolean";
    case sdk::ParameterType::kText:
      return "text";
    case sdk::ParameterType::kFile:
      return "file";
  }
  return {};
}

/// "distance(object: symbol, distance: real m)"
std::string Signature(const sdk::PredicateSpec& predicate) {
  std::vector<std::string> arguments;
  for (const sdk::ArgumentSpec& argument : predicate.arguments) {
    arguments.push_back(fmt::format("{}: {}{}{}", argument.name, Word(argument.type),
                                    argument.unit.empty() ? "" : " ", argument.unit));
  }
  if (arguments.empty()) return predicate.name;
  return fmt::format("{}({})", predicate.name, fmt::join(arguments, ", "));
}

Rows PredicateRows(std::span<const sdk::PredicateSpec> predicates) {
  Rows rows;
  for (const sdk::PredicateSpec& predicate : predicates) {
    rows.push_back({Signature(predicate), predicate.help});
  }
  return rows;
}

std::string Ports(std::string_view title, std::span<const sdk::PortSpec> ports) {
  std::string text = fmt::format("\n{}\n", title);
  if (ports.empty()) return text + "  none\n";
  for (const sdk::PortSpec& port : ports) {
    text += fmt::format("  {}{}{}{}{}\n", port.name, port.optional ? " (optional)" : "",
                        port.uninhibitable ? " (cannot be inhibited)" : "",
                        port.help.empty() ? "" : ": ", port.help);
    text += TextTable(PredicateRows(port.predicates), "    ");
  }
  return text;
}

std::string Range(const sdk::ParameterSpec& parameter) {
  if (!parameter.choices.empty()) return fmt::format("{}", fmt::join(parameter.choices, " | "));
  if (parameter.type != sdk::ParameterType::kInteger &&
      parameter.type != sdk::ParameterType::kReal) {
    return {};
  }
  const bool has_minimum = std::isfinite(parameter.minimum);
  const bool has_maximum = std::isfinite(parameter.maximum);
  if (has_minimum && has_maximum) {
    return fmt::format("{} to {}", parameter.minimum, parameter.maximum);
  }
  if (has_minimum) return fmt::format("at least {}", parameter.minimum);
  return has_maximum ? fmt::format("at most {}", parameter.maximum) : "";
}

std::string Parameters(std::span<const sdk::ParameterSpec> parameters) {
  if (parameters.empty()) return "\nParameters\n  none\n";
  Rows rows{{"name", "type", "default", "range", "unit", "meaning"}};
  for (const sdk::ParameterSpec& parameter : parameters) {
    const std::string value = parameter.default_value.value_or("(must be given)");
    rows.push_back({parameter.name, std::string(Word(parameter.type)),
                    value.empty() ? "(empty)" : value, Range(parameter), parameter.unit,
                    parameter.help});
  }
  return "\nParameters\n" + TextTable(rows, "  ");
}

std::string Header(const plugin::PluginEntry& entry) {
  return fmt::format("{} {} {}: {}\n  {}\n", plugin::Name(entry.info->kind), entry.name,
                     entry.version, entry.summary, entry.file.string());
}

std::string Example(const std::string& xml) { return "\nExample\n" + xml; }

/// The reasoner of this tree that reads a language; a language of somebody else's is guessed to be
/// named after its reasoner.
std::string_view ReasonerFor(std::string_view language) {
  return language == "tptp" ? "pttp" : language;
}

}  // namespace

std::string TextTable(const Rows& rows, const std::string& indent) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line = indent;
    for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format("{:<{}}  ", row[i], widths[i]);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string PluginPage(const plugin::PluginEntry& entry, const sdk::Layer& layer) {
  const std::vector<std::string> languages = layer.languages();
  const std::string_view reasoner = languages.empty() ? "pttp" : ReasonerFor(languages.front());
  return Header(entry) + Ports("Inputs", layer.contract().inputs) +
         Ports("Outputs", layer.contract().outputs) + Parameters(layer.parameters()) +
         fmt::format("\nLanguages of its bodies\n  {}\n", fmt::join(languages, ", ")) +
         Example(LayerExample(entry.name, layer.contract(), layer.parameters(), reasoner));
}

std::string PluginPage(const plugin::PluginEntry& entry, const sdk::Reasoner& reasoner) {
  const std::string_view language = reasoner.language();
  return Header(entry) + Parameters(reasoner.parameters()) +
         fmt::format("\nLanguage of the bodies that it reads\n  {}\n",
                     language.empty() ? "any" : language) +
         Example(ReasonerExample(entry.name, reasoner.parameters()));
}

std::string PluginPage(const plugin::PluginEntry& entry, const sdk::World& world) {
  std::string events =
      world.events().empty() ? "  none\n" : TextTable(PredicateRows(world.events()), "  ");
  return Header(entry) + Ports("Sensors", world.contract().outputs) +
         Ports("Effectors", world.contract().inputs) + Parameters(world.parameters()) +
         "\nEvents\n" + events + Example(WorldExample(entry.name, world.parameters()));
}

}  // namespace latchwork::app

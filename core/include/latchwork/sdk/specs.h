// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_SPECS_H_
#define LATCHWORK_SDK_SPECS_H_

#include <string>
#include <utility>
#include <vector>

#include "latchwork/sdk/contract.h"

namespace latchwork::sdk {

// What contracts and tables of parameters are mostly written with.

inline ArgumentSpec IntegerArgument(std::string name) {
  return {std::move(name), ArgumentType::kInteger, {}};
}

inline ArgumentSpec RealArgument(std::string name, std::string unit) {
  return {std::move(name), ArgumentType::kReal, std::move(unit)};
}

inline ArgumentSpec SymbolArgument(std::string name) {
  return {std::move(name), ArgumentType::kSymbol, {}};
}

/// A number with its default as written in XML; the bounds are inclusive.
inline ParameterSpec RealParameter(std::string name, std::string value, double minimum,
                                   double maximum, std::string unit, std::string help) {
  return {.name = std::move(name),
          .type = ParameterType::kReal,
          .default_value = std::move(value),
          .minimum = minimum,
          .maximum = maximum,
          .unit = std::move(unit),
          .help = std::move(help),
          .choices = {}};
}

inline ParameterSpec IntegerParameter(std::string name, std::string value, double minimum,
                                      double maximum, std::string help, std::string unit = {}) {
  ParameterSpec spec = RealParameter(std::move(name), std::move(value), minimum, maximum,
                                     std::move(unit), std::move(help));
  spec.type = ParameterType::kInteger;
  return spec;
}

inline ParameterSpec BooleanParameter(std::string name, bool value, std::string help) {
  return {.name = std::move(name),
          .type = ParameterType::kBoolean,
          .default_value = value ? "true" : "false",
          .unit = {},
          .help = std::move(help),
          .choices = {}};
}

/// One of these texts, the first unless another is given.
inline ParameterSpec ChoiceParameter(std::string name, std::vector<std::string> choices,
                                     std::string help) {
  return {.name = std::move(name),
          .type = ParameterType::kText,
          .default_value = choices.front(),  // NOLINT(bugprone-use-after-move): it comes first
          .unit = {},
          .help = std::move(help),
          .choices = std::move(choices)};
}

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_SPECS_H_

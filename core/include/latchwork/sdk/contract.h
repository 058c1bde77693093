// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_CONTRACT_H_
#define LATCHWORK_SDK_CONTRACT_H_

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace latchwork::sdk {

enum class ArgumentType : std::uint8_t { kInteger, kReal, kSymbol, kAny };

/// One argument of a predicate that crosses a boundary. kReal accepts integers too and must be
/// finite.
struct ArgumentSpec {
  std::string name;
  ArgumentType type = ArgumentType::kAny;
  std::string unit;  ///< "m", "rad", "m/s"; empty for none.
};

struct PredicateSpec {
  std::string name;
  std::vector<ArgumentSpec> arguments;
  std::string help;
};

/// A group of predicates whose facts travel together as one batch. An input port has one latch,
/// filled by one source.
struct PortSpec {
  std::string name;
  std::vector<PredicateSpec> predicates;
  std::string help;
  bool optional = false;       ///< Inputs: need not be wired.
  bool uninhibitable = false;  ///< Outputs: nothing may inhibit it (a safety reflex).
};

/// Which facts go in and out. For a layer: latches and conclusions. For a world: effectors in,
/// sensors out.
struct Contract {
  std::vector<PortSpec> inputs;
  std::vector<PortSpec> outputs;
};

enum class ParameterType : std::uint8_t { kInteger, kReal, kBoolean, kText, kFile };

/// A knob of a plugin, set by `<param name= value=>`. The one table that feeds checking, help and
/// documentation.
struct ParameterSpec {
  std::string name;
  ParameterType type = ParameterType::kReal;
  std::optional<std::string>
      default_value;  ///< As written in XML; nothing: the parameter must be given.
  double minimum = -std::numeric_limits<double>::infinity();  ///< Numbers only, inclusive.
  double maximum = std::numeric_limits<double>::infinity();
  std::string unit;
  std::string help;
  std::vector<std::string> choices;  ///< Text only; empty: any text.
};

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_CONTRACT_H_

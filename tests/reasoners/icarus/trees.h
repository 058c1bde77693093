// SPDX-License-Identifier: BSD-3-Clause
//
// Programs of a given size, as the shapes that behaviour trees are measured by.
#ifndef LATCHWORK_TESTS_REASONERS_ICARUS_TREES_H_
#define LATCHWORK_TESTS_REASONERS_ICARUS_TREES_H_

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/interpreter.h"

namespace latchwork::icarus::testing {

/// {yes ...} is True, {no ...} False, whatever the arguments.
class YesNoHost : public Host {
 public:
  std::span<const Signature> functions() const override {
    static constexpr std::array<Signature, 2> kFunctions = {{{"yes"}, {"no"}}};
    return kFunctions;
  }
  Value Call(std::size_t function, std::span<const Value> /*arguments*/, Arena& /*arena*/,
             NamePool& /*names*/) override {
    return function == 0 ? Value::Integer(1) : Value();
  }
};

/// One skill with so many conditions, all True, and each asked of the host; then an act.
inline std::string FlatTree(std::size_t conditions) {
  std::string text = "(Top () :requires (";
  for (std::size_t i = 0; i < conditions; ++i) text += "{yes " + std::to_string(i) + "} ";
  return text + ") :means ((Go)))\n(Go () :action ({go}))";
}

/// Skills that call each other: in every level an objective that is False, two conditions that are
/// True, and the means, the next level. With parameters, the conditions are asked of one.
inline std::string LevelTree(std::size_t levels, bool parameters) {
  const std::string variable = parameters ? " ?x" : "";
  std::string text = "(Top () :means ((l0" + std::string(parameters ? " car" : "") + ")))\n";
  for (std::size_t i = 0; i < levels; ++i) {
    const std::string at = std::to_string(i);
    text += "(l" + at + " (" + variable + ") :objective ({no " + at + variable +
            "}) :requires ({yes " + at + " a" + variable + "} {yes " + at + " b" + variable +
            "}) :means ((l" + std::to_string(i + 1) + variable + ")))\n";
  }
  return text + "(l" + std::to_string(levels) + " (" + variable + ") :action ({go" + variable +
         "}))";
}

/// A memory of so many facts of different heads, and a condition on each of the last hundred.
inline std::string ManyFacts(std::size_t facts, std::size_t matches) {
  std::string text = "(facts";
  std::string conditions;
  for (std::size_t i = 0; i < facts; ++i) {
    const std::string at = std::to_string(i);
    text += " (reading" + at + " " + at + " 1.5)";
    if (i + matches >= facts) conditions += "(reading" + at + " ?a" + at + " ?) ";
  }
  return text + ")\n(Top () :requires (" + conditions + ") :means ((Go)))\n(Go () :action ({go}))";
}

/// A program that runs, with its top (Top).
struct TreeRun {
  explicit TreeRun(const std::string& text, const RunOptions& options = {})
      : file(ReadProgram(text, "tree.icarus")), interpreter(file.program, host, names, options) {
    top = interpreter.AddTop("(Top)", findings);
  }
  const CycleResult& Cycle() { return interpreter.Cycle(top); }

  ProgramFile file;
  NamePool names;
  YesNoHost host;
  Interpreter interpreter;
  Findings findings;
  std::size_t top = 0;
};

}  // namespace latchwork::icarus::testing

#endif  // LATCHWORK_TESTS_REASONERS_ICARUS_TREES_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_ICARUS_SCRIPT_RUN_H_
#define LATCHWORK_TESTS_REASONERS_ICARUS_SCRIPT_RUN_H_

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/interpreter.h"
#include "reasoners/icarus/tools/world_script.h"

namespace latchwork::icarus::testing {

/// A program in a scripted world, run to the end of the script.
class ScriptRun {
 public:
  ScriptRun(std::string_view program, std::string_view script, const RunOptions& options = {}) {
    file_ = ReadProgram(std::string(program), "p.icarus");
    for (const Finding& finding : file_.findings) {
      EXPECT_NE(finding.severity, Severity::kError) << Format(finding);
    }
    Findings findings;
    script_ = ReadScript(std::string(script), "w.world", names_, findings);
    world_ = std::make_unique<ScriptedWorld>(script_);
    interpreter_ = std::make_unique<Interpreter>(file_.program, *world_, names_, options);
    for (const Finding& finding : interpreter_->findings()) ADD_FAILURE() << Format(finding);
    std::size_t top = AddTop(script_.top, findings);
    for (const ScriptCycle& cycle : script_.cycles) {
      if (cycle.top) top = AddTop(*cycle.top, findings);
      for (std::int64_t i = 0; i < cycle.repeat && findings.empty(); ++i) Cycle(cycle, top);
    }
    for (const Finding& finding : findings) ADD_FAILURE() << Format(finding);
  }

  Interpreter& interpreter() { return *interpreter_; }
  const NamePool& names() const { return names_; }
  const std::vector<std::uint64_t>& clauses() const { return clauses_; }
  const std::vector<std::string>& faults() const { return faults_; }
  std::string Memory() const {
    std::string text;
    for (const FactStore::Fact* fact = interpreter_->memory().First(); fact != nullptr;
         fact = fact->next) {
      if (fact->died == 0) text += ToString(fact->value, names_);
    }
    return text;
  }

 private:
  std::size_t AddTop(const std::string& text, Findings& findings) {
    return text.empty() ? Interpreter::kNoTop : interpreter_->AddTop(text, findings);
  }

  void Cycle(const ScriptCycle& cycle, std::size_t top) {
    world_->Begin(cycle, interpreter_->memory());
    const CycleResult& result = interpreter_->Cycle(cycle.idle ? Interpreter::kNoTop : top);
    clauses_.push_back(result.clauses);
    for (const Fault& fault : result.faults) faults_.push_back(fault.message);
    const std::vector<std::string> outcome = Outcome(result, names_);
    if (cycle.expected) {
      EXPECT_TRUE(Meets(outcome, *cycle.expected))
          << "line " << cycle.line << ": " << ::testing::PrintToString(outcome) << " where "
          << ::testing::PrintToString(*cycle.expected) << " was expected; memory " << Memory();
    }
  }

  NamePool names_;
  ProgramFile file_;
  WorldScript script_;
  std::unique_ptr<ScriptedWorld> world_;
  std::unique_ptr<Interpreter> interpreter_;
  std::vector<std::uint64_t> clauses_;
  std::vector<std::string> faults_;
};

}  // namespace latchwork::icarus::testing

#endif  // LATCHWORK_TESTS_REASONERS_ICARUS_SCRIPT_RUN_H_

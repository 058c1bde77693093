// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_ICARUS_REPL_COMMANDS_H_
#define LATCHWORK_APPS_LATCHWORK_ICARUS_REPL_COMMANDS_H_

#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/latchwork/icarus_debugger.h"

namespace latchwork::app {

/// The commands of `latchwork icarus repl`.
class IcarusRepl {
 public:
  explicit IcarusRepl(IcarusDebugger& debugger) : debugger_(debugger) {}

  /// Does what a line says and appends the answer; false: it says to end.
  bool Do(std::string_view line, std::string& out);

 private:
  struct Command {
    std::string_view name;
    std::string_view usage;
    std::string_view help;
    void (IcarusRepl::*act)(const std::string& rest, std::string& out);
  };
  enum class Stop { kSkill, kAct, kFact };
  struct Breakpoint {
    Stop stop = Stop::kSkill;
    std::uint32_t skill = icarus::kNoSkill;
    std::optional<icarus::Value> pattern;
    std::string text;
  };
  struct Watch {
    icarus::Value pattern;
    std::string text;
    std::vector<std::string> facts;
  };

  static std::span<const Command> Commands();
  void StepCommand(const std::string& rest, std::string& out);
  void RunCommand(const std::string& rest, std::string& out);
  void BreakCommand(const std::string& rest, std::string& out);
  void DeleteCommand(const std::string& rest, std::string& out);
  void WatchCommand(const std::string& rest, std::string& out);
  void MemoryCommand(const std::string& rest, std::string& out);
  void StoreCommand(const std::string& rest, std::string& out);
  void ForgetCommand(const std::string& rest, std::string& out);
  void UpdateCommand(const std::string& rest, std::string& out);
  void AnswerCommand(const std::string& rest, std::string& out);
  void TopCommand(const std::string& rest, std::string& out);
  void WhyCommand(const std::string& rest, std::string& out);
  void WhyNotCommand(const std::string& rest, std::string& out);
  void TraceCommand(const std::string& rest, std::string& out);
  void ReloadCommand(const std::string& rest, std::string& out);
  void HelpCommand(const std::string& rest, std::string& out);

  /// One cycle; the breakpoint that it meets.
  const Breakpoint* Cycle(std::string& out);
  const Breakpoint* Met() const;
  bool IsMet(const Breakpoint& point) const;
  void AddBreakpoint(Stop stop, const std::string& pattern, const std::string& text,
                     std::string& out);
  void Change(const std::string& head, const std::string& rest, std::string& out);
  void TellWatches(std::string& out);
  void TellTrace(std::string& out) const;
  bool HasTop(std::string& out) const;

  IcarusDebugger& debugger_;
  std::vector<Breakpoint> breakpoints_;
  std::vector<Watch> watches_;
  std::set<std::string> before_;  ///< Facts before the last cycle.
  bool traces_ = false;
};

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_ICARUS_REPL_COMMANDS_H_

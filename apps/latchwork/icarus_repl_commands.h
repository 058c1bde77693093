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

/// Where further commands come from while a cycle is under way.
class IcarusConsole {
 public:
  virtual ~IcarusConsole() = default;
  /// Prints what was answered so far and reads a line; false at the end of input.
  virtual bool Ask(const std::string& answer, std::string& line) = 0;
};

/// The commands of `latchwork icarus repl`.
class IcarusRepl {
 public:
  IcarusRepl(IcarusDebugger& debugger, IcarusConsole& console);

  /// Does what a line says and appends the answer; false: it says to end.
  bool Do(std::string_view line, std::string& out);

 private:
  struct Command {
    std::string_view name;
    std::string_view usage;
    std::string_view help;
    void (IcarusRepl::*act)(const std::string& rest, std::string& out);
  };
  enum class Stop { kSkill, kInside, kFalse, kAct, kFact };
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
  void FailCommand(const std::string& rest, std::string& out);
  void TopCommand(const std::string& rest, std::string& out);
  void WhyCommand(const std::string& rest, std::string& out);
  void WhyNotCommand(const std::string& rest, std::string& out);
  void TraceCommand(const std::string& rest, std::string& out);
  void ReloadCommand(const std::string& rest, std::string& out);
  void HelpCommand(const std::string& rest, std::string& out);

  // icarus_repl_pause.cc
  void OnEvent(const icarus::TraceEntry& entry);
  bool PausesAt(const icarus::TraceEntry& entry) const;
  void Pause(const icarus::TraceEntry& entry);
  bool DoInside(const std::string& line, const icarus::TraceEntry& entry);
  void TellCallers(const icarus::TraceEntry& entry);

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
  IcarusConsole& console_;
  std::vector<Breakpoint> breakpoints_;
  std::vector<Watch> watches_;
  std::set<std::string> before_;  ///< Facts before the last cycle.
  bool traces_ = false;
  std::string inside_;        ///< What a cycle under way has answered.
  bool follows_ = false;      ///< Pauses at every event.
  std::uint32_t out_of_ = 0;  ///< Pauses when this call, a number of an event, has ended; 0: none.
  bool released_ = false;     ///< Does not pause any more in this cycle.
  bool ends_ = false;
};

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_ICARUS_REPL_COMMANDS_H_

// SPDX-License-Identifier: BSD-3-Clause
//
// Commands within a cycle: it waits at a skill, and may be looked at, but not changed.
#include <fmt/format.h>

#include <algorithm>

#include "apps/latchwork/icarus_repl_commands.h"

namespace latchwork::app {

IcarusRepl::IcarusRepl(IcarusDebugger& debugger, IcarusConsole& console)
    : debugger_(debugger), console_(console) {
  debugger_.SetObserver([this](const icarus::TraceEntry& entry) { OnEvent(entry); });
}

void IcarusRepl::OnEvent(const icarus::TraceEntry& entry) {
  if (released_) return;
  const bool met = entry.kind == icarus::EventKind::kCall &&
                   std::any_of(breakpoints_.begin(), breakpoints_.end(), [&](const auto& point) {
                     return point.stop == Stop::kInside && point.skill == entry.skill;
                   });
  if (!met && !follows_) return;
  const std::string line = icarus::TraceLine(entry);
  if (line.empty() && !met) return;
  if (met) inside_ += fmt::format("break in cycle {}:\n", debugger_.cycle());
  inside_ += line + '\n';
  Pause(entry);
}

void IcarusRepl::Pause(const icarus::TraceEntry& entry) {
  follows_ = false;
  std::string line;
  while (!released_) {
    if (!console_.Ask(inside_, line)) ends_ = released_ = true;
    inside_.clear();
    if (released_) return;
    if (line == "where") {
      TellCallers(entry);
    } else if (DoInside(line)) {
      return;
    }
  }
}

/// True: the cycle goes on.
bool IcarusRepl::DoInside(const std::string& line) {
  if (line == "continue") return true;
  if (line == "next") return follows_ = true;
  if (line == "finish") return released_ = true;
  if (line == "quit" || line == "exit") return ends_ = released_ = true;
  if (line == "trace") {
    TellTrace(inside_);
  } else if (line == "memory" || line.starts_with("memory (")) {
    MemoryCommand(line == "memory" ? "" : line.substr(line.find('(')), inside_);
  } else if (!line.empty()) {
    inside_ +=
        "a cycle is under way: continue (to the next break), next (event), finish (the cycle), "
        "where, memory [(F ..)], trace, quit\n";
  }
  return false;
}

/// The skills that are being asked, the innermost first.
void IcarusRepl::TellCallers(const icarus::TraceEntry& entry) {
  const std::vector<icarus::TraceEntry>& entries = debugger_.entries();
  std::uint32_t number = entry.kind == icarus::EventKind::kCall ? entry.number : entry.in;
  while (number != 0) {
    const auto call = std::find_if(entries.rbegin(), entries.rend(),
                                   [&](const auto& each) { return each.number == number; });
    if (call == entries.rend()) return;
    inside_ += call->clause;
    if (call->line != 0) inside_ += fmt::format("  [{}:{}]", call->line, call->column);
    inside_ += '\n';
    number = call->in;
  }
}

}  // namespace latchwork::app

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

bool IcarusRepl::PausesAt(const icarus::TraceEntry& entry) const {
  const bool returns = entry.kind == icarus::EventKind::kReturn;
  const bool is_false = returns && !entry.truth && !entry.acted;
  return std::any_of(breakpoints_.begin(), breakpoints_.end(), [&](const Breakpoint& point) {
    const bool met = (point.stop == Stop::kInside && entry.kind == icarus::EventKind::kCall) ||
                     (point.stop == Stop::kFalse && is_false);
    return met && point.skill == entry.skill;
  });
}

void IcarusRepl::OnEvent(const icarus::TraceEntry& entry) {
  if (released_) return;
  const bool met = PausesAt(entry);
  const bool is_over =
      entry.kind == icarus::EventKind::kTrue || entry.kind == icarus::EventKind::kReturn;
  const bool is_out = is_over && entry.index == out_of_;
  if (!met && !is_out && !follows_) return;
  const std::string line = icarus::TraceLine(entry);
  if (line.empty() && !met) return;
  if (met) inside_ += fmt::format("break in cycle {}:\n", debugger_.cycle());
  inside_ += line + '\n';
  Pause(entry);
}

void IcarusRepl::Pause(const icarus::TraceEntry& entry) {
  follows_ = false;
  out_of_ = 0;
  std::string line;
  while (!released_) {
    if (!console_.Ask(inside_, line)) ends_ = released_ = true;
    inside_.clear();
    if (released_) return;
    if (line == "where") {
      TellCallers(entry);
    } else if (DoInside(line, entry)) {
      return;
    }
  }
}

/// True: the cycle goes on.
bool IcarusRepl::DoInside(const std::string& line, const icarus::TraceEntry& entry) {
  if (line == "continue") return true;
  if (line == "next") return follows_ = true;
  if (line == "out") {
    out_of_ = entry.kind == icarus::EventKind::kCall ? entry.number : entry.in;
    return true;
  }
  if (line == "finish") return released_ = true;
  if (line == "quit" || line == "exit") return ends_ = released_ = true;
  if (line == "trace") {
    TellTrace(inside_);
  } else if (line == "memory" || line.starts_with("memory (")) {
    MemoryCommand(line == "memory" ? "" : line.substr(line.find('(')), inside_);
  } else if (!line.empty()) {
    inside_ +=
        "a cycle is under way: continue (to the next break), next (event), out (of this skill), "
        "finish (the cycle), where, memory [(F ..)], trace, quit\n";
  }
  return false;
}

/// The skills that are being asked, the innermost first.
void IcarusRepl::TellCallers(const icarus::TraceEntry& entry) {
  const std::vector<icarus::TraceEntry>& entries = debugger_.entries();
  std::uint32_t number = entry.in;
  if (entry.kind == icarus::EventKind::kCall) number = entry.number;
  if (entry.kind == icarus::EventKind::kReturn) number = entry.index;
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

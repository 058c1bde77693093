// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/icarus_repl_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include "latchwork/logic/diagnostic.h"
#include "reasoners/icarus/language/reader.h"
#include "reasoners/icarus/tools/why.h"

namespace latchwork::app {

namespace {

constexpr std::uint64_t kMostCycles = 1'000'000;
constexpr std::uint64_t kFreeRun = 1000;  // Cycles of `run` after the end of the script.

std::string Trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n\v\f";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(kSpace) - first + 1));
}

std::pair<std::string, std::string> FirstWord(const std::string& line) {
  const std::size_t end = std::min(line.find_first_of(" \t("), line.size());
  return {line.substr(0, end), Trimmed(std::string_view(line).substr(end))};
}

/// A number of cycles; `otherwise` for no text, nothing for another text.
std::optional<std::uint64_t> Count(const std::string& text, std::uint64_t otherwise) {
  if (text.empty()) return otherwise;
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return std::min(count, kMostCycles);
}

/// Whether the act is what a list says, (go ?): a function and its arguments.
bool IsAct(const icarus::Value& pattern, const icarus::Act& act) {
  const std::span<const icarus::Value> items = pattern.list->items();
  return std::any_of(act.calls.begin(), act.calls.end(), [&](const icarus::ActCall& call) {
    return items.size() == call.arguments.size() + 1 &&
           icarus::Fits(items[0], icarus::Value::Symbol(call.function)) &&
           std::equal(call.arguments.begin(), call.arguments.end(), items.begin() + 1,
                      [](const icarus::Value& value, const icarus::Value& item) {
                        return icarus::Fits(item, value);
                      });
  });
}

/// The words of `Ram car1` or `(Ram car1)`.
std::vector<std::string> CallWords(std::string text) {
  if (!text.starts_with('(')) text = "(" + text + ")";
  icarus::Findings findings;
  const icarus::SourceTree tree = icarus::ReadForms(std::move(text), "call", findings);
  std::vector<std::string> words;
  if (!findings.empty() || tree.roots.size() != 1) return words;
  for (const icarus::FormId child : tree.Children(tree.roots[0])) {
    words.emplace_back(tree.Text(child));
  }
  return words;
}

std::string UnknownSkill(const std::string& name, const icarus::Program& program) {
  std::vector<std::string> known;
  for (const icarus::Skill& skill : program.skills) known.push_back(skill.spelling);
  const std::string_view nearest = logic::NearestName(name, known);
  return fmt::format("there is no skill '{}'{}\n", name,
                     nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest));
}

}  // namespace

std::span<const IcarusRepl::Command> IcarusRepl::Commands() {
  static constexpr std::array<Command, 19> kCommands = {{
      {"step", "step [N]", "run the next cycle, or N", &IcarusRepl::StepCommand},
      {"run", "run [N]", "run to the end of the script, or N cycles, or to a break",
       &IcarusRepl::RunCommand},
      {"break", "break [SKILL | act {F ..} | fact (F ..)]",
       "stop after a cycle that calls the skill, chooses the act or gets the fact; or list",
       &IcarusRepl::BreakCommand},
      {"break", "break in SKILL",
       "stop within a cycle, where the skill is called; then: next, out, continue, finish, where",
       &IcarusRepl::BreakCommand},
      {"break", "break false SKILL", "stop within a cycle, where the skill has come to False",
       &IcarusRepl::BreakCommand},
      {"delete", "delete [N]", "delete break N, or all", &IcarusRepl::DeleteCommand},
      {"watch", "watch [(F ..) | off]", "tell which facts come and go; or list, or end it",
       &IcarusRepl::WatchCommand},
      {"memory", "memory [(F ..)]", "the facts of memory, or those that match",
       &IcarusRepl::MemoryCommand},
      {"store", "store (F ..)", "put a fact into memory", &IcarusRepl::StoreCommand},
      {"forget", "forget (F ..)", "take out the facts that match", &IcarusRepl::ForgetCommand},
      {"update", "update (F ..) (G ..)", "put the second in place of what matches the first",
       &IcarusRepl::UpdateCommand},
      {"answer", "answer {F ..} VALUE", "what a sensor answers from now on; nil is False",
       &IcarusRepl::AnswerCommand},
      {"fail", "fail {F ..} \"MESSAGE\"", "a sensor fails from now on, until it is answered",
       &IcarusRepl::FailCommand},
      {"top", "top [(SKILL ..)]", "the top call, or another one", &IcarusRepl::TopCommand},
      {"why", "why", "how the last act came about", &IcarusRepl::WhyCommand},
      {"why-not", "why-not SKILL [ARGUMENT ..]", "what became of the skill in the last cycle",
       &IcarusRepl::WhyNotCommand},
      {"trace", "trace [on | off]", "all events of the last cycle, or of each that follows",
       &IcarusRepl::TraceCommand},
      {"reload", "reload", "read the program again; memory and unchanged sequences stay",
       &IcarusRepl::ReloadCommand},
      {"help", "help", "this list; 'quit' ends", &IcarusRepl::HelpCommand},
  }};
  return kCommands;
}

bool IcarusRepl::Do(std::string_view line, std::string& out) {
  const auto [word, rest] = FirstWord(Trimmed(line));
  if (word == "quit" || word == "exit") ends_ = true;
  if (ends_) return false;
  if (word.empty() && rest.empty()) return true;
  for (const Command& command : Commands()) {
    if (command.name != word) continue;
    (this->*command.act)(rest, out);
    return !ends_;
  }
  if (word == "continue" || word == "next" || word == "out" || word == "finish" ||
      word == "where") {
    out += fmt::format("'{}' is for a break within a cycle; 'break in SKILL' makes one\n", word);
    return true;
  }
  std::vector<std::string> known = {"quit"};
  for (const Command& command : Commands()) known.emplace_back(command.name);
  const std::string_view nearest = logic::NearestName(word, known);
  out += nearest.empty() ? "no such command; 'help' lists them\n"
                         : fmt::format("no such command; did you mean '{}'?\n", nearest);
  return true;
}

void IcarusRepl::HelpCommand(const std::string& /*rest*/, std::string& out) {
  for (const Command& command : Commands()) {
    out += fmt::format("{:<42} {}\n", command.usage, command.help);
  }
}

bool IcarusRepl::HasTop(std::string& out) const {
  if (debugger_.top().empty() && debugger_.script_has_ended()) {
    out += "no top call is given; 'top (Skill argument ..)' gives one\n";
    return false;
  }
  return true;
}

const IcarusRepl::Breakpoint* IcarusRepl::Cycle(std::string& out) {
  const std::vector<std::string> facts = debugger_.Memory(std::nullopt);
  before_ = std::set<std::string>(facts.begin(), facts.end());
  inside_ = std::exchange(out, {});
  follows_ = released_ = false;
  out_of_ = 0;
  debugger_.Step();
  out = std::exchange(inside_, {});
  if (traces_) TellTrace(out);
  out += debugger_.Line() + '\n';
  for (const std::string& fault : debugger_.Faults()) out += fault + '\n';
  if (!debugger_.is_as_expected()) out += "this is not what the script expects\n";
  TellWatches(out);
  return Met();
}

void IcarusRepl::StepCommand(const std::string& rest, std::string& out) {
  const std::optional<std::uint64_t> count = Count(rest, 1);
  if (!count) {
    out += "step [N]: N is a number of cycles\n";
    return;
  }
  if (!HasTop(out)) return;
  for (std::uint64_t i = 0; i < *count && !ends_; ++i) Cycle(out);
}

void IcarusRepl::RunCommand(const std::string& rest, std::string& out) {
  const std::optional<std::uint64_t> count = Count(rest, 0);
  if (!count) {
    out += "run [N]: N is a number of cycles\n";
    return;
  }
  if (!HasTop(out)) return;
  const bool free = rest.empty() && debugger_.script_has_ended();
  const std::uint64_t most = free ? kFreeRun : rest.empty() ? kMostCycles : *count;
  for (std::uint64_t i = 0; i < most && !ends_; ++i) {
    const Breakpoint* const met = Cycle(out);
    if (met != nullptr) {
      out += fmt::format("break: {}\n", met->text);
      return;
    }
    const bool ended = rest.empty() && !free && debugger_.script_has_ended();
    const bool settled =
        free && (debugger_.result().environments > 0 || debugger_.result().fault_count > 0);
    if (ended || settled) return;
  }
}

const IcarusRepl::Breakpoint* IcarusRepl::Met() const {
  const auto met = std::find_if(breakpoints_.begin(), breakpoints_.end(),
                                [this](const Breakpoint& point) { return IsMet(point); });
  return met == breakpoints_.end() ? nullptr : &*met;
}

bool IcarusRepl::IsMet(const Breakpoint& point) const {
  switch (point.stop) {
    case Stop::kSkill:
      return std::any_of(debugger_.entries().begin(), debugger_.entries().end(),
                         [&](const icarus::TraceEntry& entry) {
                           return entry.kind == icarus::EventKind::kCall &&
                                  entry.skill == point.skill;
                         });
    case Stop::kAct: {
      const auto acts = debugger_.result().acts;
      return std::any_of(acts.begin(), acts.end(), [&](const icarus::Act& act) {
        return !point.pattern || IsAct(*point.pattern, act);
      });
    }
    case Stop::kInside:
    case Stop::kFalse:
      return false;
    case Stop::kFact:
      break;
  }
  const std::vector<std::string> facts = debugger_.Memory(point.pattern);
  return std::any_of(facts.begin(), facts.end(),
                     [this](const std::string& fact) { return !before_.contains(fact); });
}

void IcarusRepl::AddBreakpoint(Stop stop, const std::string& pattern, const std::string& text,
                               std::string& out) {
  Breakpoint point;
  point.stop = stop;
  point.text = text;
  if (!pattern.empty()) {
    std::string list = pattern;
    if (stop == Stop::kAct && list.starts_with('{') && list.ends_with('}')) {
      list = "(" + list.substr(1, list.size() - 2) + ")";
    }
    point.pattern = debugger_.ReadPattern(list);
    const bool whole = point.pattern && point.pattern->kind == icarus::ValueKind::kList &&
                       !point.pattern->list->items().empty();
    if (!whole) {
      out += fmt::format("'{}' is no pattern\n", pattern);
      return;
    }
  }
  breakpoints_.push_back(std::move(point));
}

void IcarusRepl::BreakCommand(const std::string& rest, std::string& out) {
  const auto [word, pattern] = FirstWord(rest);
  if (rest.empty()) {
    for (std::size_t i = 0; i < breakpoints_.size(); ++i) {
      out += fmt::format("{}: {}\n", i + 1, breakpoints_[i].text);
    }
  } else if (word == "act") {
    AddBreakpoint(Stop::kAct, pattern, rest, out);
  } else if (word == "fact" && !pattern.empty()) {
    AddBreakpoint(Stop::kFact, pattern, rest, out);
  } else {
    const bool inside = (word == "in" || word == "false") && !pattern.empty();
    const std::string& name = inside ? pattern : rest;
    const Stop within = word == "in" ? Stop::kInside : Stop::kFalse;
    const std::uint32_t skill = debugger_.program().Find(name);
    if (skill == icarus::kNoSkill) {
      out += UnknownSkill(name, debugger_.program());
    } else {
      breakpoints_.push_back({inside ? within : Stop::kSkill, skill, std::nullopt, rest});
    }
  }
}

void IcarusRepl::DeleteCommand(const std::string& rest, std::string& out) {
  const std::optional<std::uint64_t> number = Count(rest, 0);
  if (rest.empty()) {
    breakpoints_.clear();
  } else if (number && *number >= 1 && *number <= breakpoints_.size()) {
    breakpoints_.erase(breakpoints_.begin() + static_cast<std::ptrdiff_t>(*number - 1));
  } else {
    out += fmt::format("there is no break {}\n", rest);
  }
}

void IcarusRepl::WatchCommand(const std::string& rest, std::string& out) {
  if (rest.empty()) {
    for (const Watch& watch : watches_) out += watch.text + '\n';
    return;
  }
  if (rest == "off") return watches_.clear();
  const std::optional<icarus::Value> pattern = debugger_.ReadPattern(rest);
  if (!pattern) {
    out += fmt::format("'{}' is no pattern\n", rest);
    return;
  }
  watches_.push_back({*pattern, rest, debugger_.Memory(pattern)});
}

void IcarusRepl::TellWatches(std::string& out) {
  for (Watch& watch : watches_) {
    std::vector<std::string> now = debugger_.Memory(watch.pattern);
    const std::set<std::string> old(watch.facts.begin(), watch.facts.end());
    const std::set<std::string> fresh(now.begin(), now.end());
    for (const std::string& fact : watch.facts) {
      if (!fresh.contains(fact)) out += "- " + fact + '\n';
    }
    for (const std::string& fact : now) {
      if (!old.contains(fact)) out += "+ " + fact + '\n';
    }
    watch.facts = std::move(now);
  }
}

void IcarusRepl::MemoryCommand(const std::string& rest, std::string& out) {
  std::optional<icarus::Value> pattern;
  if (!rest.empty()) {
    pattern = debugger_.ReadPattern(rest);
    if (!pattern) {
      out += fmt::format("'{}' is no pattern\n", rest);
      return;
    }
  }
  for (const std::string& fact : debugger_.Memory(pattern)) out += fact + '\n';
}

void IcarusRepl::Change(const std::string& head, const std::string& rest, std::string& out) {
  const std::optional<std::string> problem = debugger_.Apply(fmt::format("({} {})", head, rest));
  if (problem) out += *problem + '\n';
}

void IcarusRepl::StoreCommand(const std::string& rest, std::string& out) {
  Change("store", rest, out);
}
void IcarusRepl::ForgetCommand(const std::string& rest, std::string& out) {
  Change("forget", rest, out);
}
void IcarusRepl::UpdateCommand(const std::string& rest, std::string& out) {
  Change("update", rest, out);
}
void IcarusRepl::AnswerCommand(const std::string& rest, std::string& out) {
  Change("answer", rest, out);
}
void IcarusRepl::FailCommand(const std::string& rest, std::string& out) {
  Change("fail", rest, out);
}

void IcarusRepl::TopCommand(const std::string& rest, std::string& out) {
  const std::vector<std::string> words = CallWords(rest);
  const bool named = rest.starts_with('(') && !words.empty() && !words[0].starts_with('*');
  if (rest.empty()) {
    out += debugger_.top() + '\n';
  } else if (named && debugger_.program().Find(words[0]) == icarus::kNoSkill) {
    out += UnknownSkill(words[0], debugger_.program());
  } else if (const std::optional<std::string> problem = debugger_.SetTop(rest)) {
    out += *problem + '\n';
  }
}

void IcarusRepl::WhyCommand(const std::string& /*rest*/, std::string& out) {
  if (!debugger_.has_run() || debugger_.result().acts.empty()) {
    out += "the last cycle has no act\n";
    return;
  }
  for (const icarus::Act& act : debugger_.result().acts) {
    out += icarus::Why(act, debugger_.program(), debugger_.names());
  }
  for (const icarus::TraceEntry& entry : debugger_.entries()) {
    if (entry.kind != icarus::EventKind::kHost) continue;
    out += "sensor: " + entry.call + " = " + entry.answer.value_or("nil") + '\n';
  }
}

void IcarusRepl::WhyNotCommand(const std::string& rest, std::string& out) {
  const std::vector<std::string> words = CallWords(rest);
  if (words.empty()) {
    out += "why-not SKILL [ARGUMENT ..]\n";
    return;
  }
  icarus::CallPattern pattern;
  pattern.skill = debugger_.program().Find(words[0]);
  pattern.arguments.assign(words.begin() + 1, words.end());
  if (pattern.skill == icarus::kNoSkill) {
    out += UnknownSkill(words[0], debugger_.program());
  } else if (!debugger_.has_run()) {
    out += "no cycle has been run\n";
  } else if (debugger_.is_cut()) {
    out += "the last cycle has too many events\n";
  } else {
    out += icarus::WhyNot(pattern, {debugger_.entries(), debugger_.Memory(std::nullopt)},
                          debugger_.program());
  }
}

void IcarusRepl::TellTrace(std::string& out) const {
  for (const icarus::TraceEntry& entry : debugger_.entries()) {
    const std::string line = icarus::TraceLine(entry);
    if (!line.empty()) out += line + '\n';
  }
  if (debugger_.is_cut()) out += "(the rest is not kept)\n";
}

void IcarusRepl::TraceCommand(const std::string& rest, std::string& out) {
  if (rest.empty()) return TellTrace(out);
  if (rest == "on" || rest == "off") {
    traces_ = rest == "on";
  } else {
    out += "trace [on | off]\n";
  }
}

void IcarusRepl::ReloadCommand(const std::string& /*rest*/, std::string& out) {
  if (!debugger_.Reload()) {
    out += "the old program goes on\n";
    return;
  }
  std::erase_if(breakpoints_, [this](Breakpoint& point) {
    if (point.pattern || point.skill == icarus::kNoSkill) return false;
    const bool is_called = point.stop == Stop::kSkill;
    point.skill = debugger_.program().Find(is_called ? point.text : FirstWord(point.text).second);
    return point.skill == icarus::kNoSkill;
  });
  out += fmt::format("{} skills\n", debugger_.program().skills.size());
}

}  // namespace latchwork::app

// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/icarus_debugger.h"

#include <fmt/format.h>

#include <cstdio>
#include <limits>
#include <set>
#include <utility>

#include "apps/latchwork/icarus_command.h"
#include "reasoners/icarus/language/signature.h"
#include "reasoners/icarus/language/walk.h"

namespace latchwork::app {

namespace {

/// Events of a cycle that are kept.
constexpr std::size_t kMostEvents = 200'000;

/// The host functions that a program calls.
std::set<std::string> CalledFunctions(const icarus::Program& program) {
  std::set<std::string> called;
  const auto visit = [&](const icarus::Term& term) {
    const bool host =
        term.kind == icarus::TermKind::kCall && icarus::FindBuiltin(term.text) == nullptr;
    if (host) called.insert(term.text);
  };
  for (const icarus::Skill& skill : program.skills) {
    if (skill.value) icarus::WalkTerm(*skill.value, visit);
    if (skill.type == icarus::SkillType::kAction) continue;
    icarus::WalkTerms(skill, [&](const icarus::Term& term, icarus::Slot) { visit(term); });
  }
  return called;
}

std::string Message(const icarus::Findings& findings) {
  const logic::Diagnostic& first = findings.front().diagnostic;
  return first.hint.empty() ? first.message : first.message + " (" + first.hint + ")";
}

}  // namespace

std::unique_ptr<icarus::ProgramFile> IcarusDebugger::ReadFile() {
  std::optional<std::string> text = ReadProgramText(settings_.program);
  if (!text) return nullptr;
  auto file = std::make_unique<icarus::ProgramFile>(
      icarus::ReadProgram(*std::move(text), settings_.program));
  if (!icarus::HasErrors(file->findings)) return file;
  PrintFindings(settings_.program, file->findings);
  return nullptr;
}

/// What the program calls is False until it is answered.
bool IcarusDebugger::DeclareFunctions(const icarus::Program& program) {
  std::string form = "(functions";
  for (const std::string& name : CalledFunctions(program)) form += ' ' + name;
  icarus::Findings findings;
  icarus::ExtendScript(form + ")", "functions", names_, script_, findings);
  return findings.empty();
}

bool IcarusDebugger::MakeInterpreter(const icarus::Program& program,
                                     std::unique_ptr<icarus::Interpreter>& interpreter) {
  interpreter = std::make_unique<icarus::Interpreter>(program, *world_, names_, settings_.options);
  if (!icarus::HasErrors(interpreter->findings())) return true;
  PrintFindings(settings_.program, interpreter->findings());
  return false;
}

bool IcarusDebugger::Open() {
  file_ = ReadFile();
  if (file_ == nullptr || !DeclareFunctions(file_->program)) return false;
  if (!settings_.script.empty()) {
    std::optional<std::string> text = ReadProgramText(settings_.script);
    if (!text) return false;
    icarus::Findings findings;
    icarus::ExtendScript(*std::move(text), settings_.script, names_, script_, findings);
    PrintFindings(settings_.script, findings);
    if (icarus::HasErrors(findings)) return false;
  }
  world_ = std::make_unique<icarus::ScriptedWorld>(script_);
  if (!MakeInterpreter(file_->program, interpreter_)) return false;
  interpreter_->SetSink(this);
  if (!settings_.top.empty()) {
    const std::optional<std::string> problem = SetTop(settings_.top);
    if (problem) fmt::print(stderr, "--top: error: {}\n", *problem);
    return !problem;
  }
  if (script_.top.empty()) {
    icarus::Findings findings;
    top_ = interpreter_->AddTop(findings);
    if (top_ != icarus::Interpreter::kNoTop) top_text_ = interpreter_->TopText(top_);
    return true;
  }
  const std::optional<std::string> problem = SetTop(script_.top);
  if (problem) fmt::print(stderr, "{}: error: {}\n", settings_.script, *problem);
  return !problem;
}

bool IcarusDebugger::Reload() {
  std::unique_ptr<icarus::ProgramFile> file = ReadFile();
  if (file == nullptr || !DeclareFunctions(file->program)) return false;
  std::unique_ptr<icarus::Interpreter> interpreter;
  if (!MakeInterpreter(file->program, interpreter)) return false;
  icarus::Findings findings;
  std::size_t top = icarus::Interpreter::kNoTop;
  if (!top_text_.empty()) top = interpreter->AddTop(top_text_, findings);
  if (icarus::HasErrors(findings)) {
    PrintFindings("top", findings);
    return false;
  }
  interpreter->TakeOver(*interpreter_, std::numeric_limits<std::size_t>::max());
  describer_.reset();
  entries_.clear();
  result_ = nullptr;
  interpreter_ = std::move(interpreter);
  file_ = std::move(file);
  top_ = top;
  interpreter_->SetSink(this);
  return true;
}

std::optional<std::string> IcarusDebugger::SetTop(const std::string& call) {
  icarus::Findings findings;
  const std::size_t top = interpreter_->AddTop(call, findings);
  if (icarus::HasErrors(findings)) return Message(findings);
  top_ = top;
  top_text_ = call;
  return std::nullopt;
}

const icarus::ScriptCycle* IcarusDebugger::NextCycle() {
  if (script_has_ended()) return nullptr;
  const icarus::ScriptCycle& cycle = script_.cycles[next_];
  if (++repeated_ < cycle.repeat) return &cycle;
  repeated_ = 0;
  ++next_;
  return &cycle;
}

const icarus::CycleResult& IcarusDebugger::Step() {
  const icarus::ScriptCycle* const cycle = NextCycle();
  const bool idle = cycle != nullptr && cycle->idle;
  if (cycle != nullptr) world_->Begin(*cycle, interpreter_->memory());
  if (cycle != nullptr && cycle->top) SetTop(*cycle->top);
  now_ = idle ? icarus::Interpreter::kNoTop : top_;
  entries_.clear();
  cut_ = false;
  describer_.reset();
  if (now_ != icarus::Interpreter::kNoTop) {
    describer_.emplace(file_->program, interpreter_->TopSource(now_),
                       interpreter_->TopVariables(now_), names_);
  }
  result_ = &interpreter_->Cycle(now_);
  as_expected_ = cycle == nullptr || !cycle->expected ||
                 icarus::Meets(icarus::Outcome(*result_, names_), *cycle->expected);
  return *result_;
}

void IcarusDebugger::OnEvent(const icarus::Event& event) {
  cut_ = cut_ || entries_.size() >= kMostEvents;
  if (!describer_ || cut_) return;
  entries_.push_back(describer_->Describe(event));
  if (observer_) observer_(entries_.back());
}

std::optional<icarus::ScriptCycle> IcarusDebugger::ReadItem(const std::string& item,
                                                            std::string& message) {
  icarus::Findings findings;
  const std::size_t before = script_.cycles.size();
  const std::string top = script_.top;
  icarus::ExtendScript("(cycle " + item + ")", "input", names_, script_, findings);
  script_.top = top;
  std::optional<icarus::ScriptCycle> cycle;
  if (findings.empty() && script_.cycles.size() == before + 1) {
    cycle = std::move(script_.cycles.back());
  } else {
    message = findings.empty() ? "this is no single item" : findings.front().diagnostic.message;
  }
  script_.cycles.resize(before);
  return cycle;
}

std::optional<std::string> IcarusDebugger::Apply(const std::string& item) {
  std::string message;
  std::optional<icarus::ScriptCycle> cycle = ReadItem(item, message);
  if (!cycle) return message;
  by_hand_.push_back(*std::move(cycle));
  world_->Begin(by_hand_.back(), interpreter_->memory());
  return std::nullopt;
}

std::optional<icarus::Value> IcarusDebugger::ReadPattern(const std::string& text) {
  std::string message;
  const std::optional<icarus::ScriptCycle> cycle = ReadItem("(forget " + text + ")", message);
  if (!cycle || cycle->forgotten.size() != 1) return std::nullopt;
  return cycle->forgotten.front();
}

std::string IcarusDebugger::Line() const {
  return CycleLine(*interpreter_, names_, now_, *result_);
}

std::vector<std::string> IcarusDebugger::Faults() const {
  return FaultTexts(file_->program, interpreter_->cycle(), *result_);
}

std::vector<std::string> IcarusDebugger::Memory(const std::optional<icarus::Value>& pattern) const {
  std::vector<std::string> facts;
  const icarus::FactStore& memory = interpreter_->memory();
  for (const auto* fact = memory.First(); fact != nullptr; fact = fact->next) {
    const bool fits = fact->died == 0 && (!pattern || icarus::Fits(*pattern, fact->value));
    if (fits) facts.push_back(icarus::ToString(fact->value, names_));
  }
  return facts;
}

}  // namespace latchwork::app

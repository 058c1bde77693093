// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/tools/trace_entry.h"

#include <algorithm>
#include <array>

#include "reasoners/icarus/machine/interpreter.h"
#include "reasoners/icarus/tools/world_script.h"

namespace latchwork::icarus {

namespace {

constexpr std::size_t kPlaceWidth = 8;
constexpr std::size_t kMostIndent = 60;

std::string_view Truth(const TraceEntry& entry) {
  if (entry.truth) return " True";
  return entry.acted ? " acts" : " False";
}

std::string StepText(const TraceEntry& entry) {
  const std::string step = "step " + std::to_string(entry.index);
  if (entry.kind == EventKind::kStepEnd) return step + std::string(Truth(entry));
  return entry.clause.empty() ? "finished" : step + ' ' + entry.clause;
}

std::string HostText(const TraceEntry& entry) {
  std::string text = entry.call;
  if (!entry.text.empty()) return text.append(" failed: ").append(entry.text);
  text += " = " + entry.answer.value_or("nil");
  return entry.kind == EventKind::kKnown ? text + " (known)" : text;
}

std::string WithBindings(std::string text, const TraceEntry& entry) {
  for (const auto& [name, value] : entry.bindings) {
    text.append(" ").append(name).append("=").append(value);
  }
  return text;
}

std::string What(const TraceEntry& entry) {
  switch (entry.kind) {
    case EventKind::kCall:
      return entry.call;
    case EventKind::kAct:
    case EventKind::kDropped:
    case EventKind::kChosen:
      break;
    case EventKind::kTrue:
      return WithBindings(entry.clause + (entry.truth ? " True" : " True again"), entry);
    case EventKind::kReturn:
      return entry.truth ? "" : entry.clause + std::string(Truth(entry));
    case EventKind::kTest:
    case EventKind::kBind:
    case EventKind::kNot:
    case EventKind::kMatch:
      return WithBindings(entry.clause + std::string(Truth(entry)), entry);
    case EventKind::kHost:
    case EventKind::kKnown:
      return HostText(entry);
    case EventKind::kObjective:
      return entry.truth ? "" : "objective False";
    case EventKind::kMeans:
      return "means " + std::to_string(entry.index) + ' ' + entry.clause;
    case EventKind::kStep:
    case EventKind::kStepEnd:
      return StepText(entry);
    case EventKind::kStore:
    case EventKind::kForget:
      return std::string(NameOf(entry.kind)) + ' ' + entry.answer.value_or("");
    case EventKind::kTop:
      return WithBindings("True", entry);
    case EventKind::kFault:
      return "fault: " + entry.text;
  }
  return std::string(NameOf(entry.kind)) + ' ' + entry.act;
}

}  // namespace

std::string_view NameOf(EventKind kind) {
  constexpr std::array<std::string_view, kEventKinds> kNames = {
      "call",   "true", "return",    "test",  "host",   "known",    "bind",
      "match",  "not",  "objective", "means", "step",   "step-end", "store",
      "forget", "act",  "dropped",   "top",   "chosen", "fault"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::span<const std::string> EventDescriber::VariablesOf(std::uint32_t body) const {
  return body == kNoSkill ? top_variables_
                          : std::span<const std::string>(program_.skills[body].variables);
}

TraceEntry EventDescriber::Describe(const Event& event) const {
  TraceEntry entry;
  entry.kind = event.kind;
  entry.truth = event.truth;
  entry.acted = event.acted;
  entry.number = event.number;
  entry.in = event.in;
  entry.depth = event.depth;
  entry.index = event.index;
  entry.skill = event.skill;
  entry.body = event.body;
  entry.text = event.text;
  SetClause(event, entry);
  const auto variables = VariablesOf(event.body);
  for (const Binding& binding : event.bindings) {
    entry.bindings.emplace_back(variables[binding.variable], ToString(binding.value, names_));
  }
  if (!event.answer.is_none()) entry.answer = ToString(event.answer, names_);
  if (event.act != nullptr) entry.act = ToString(*event.act, names_);
  if (event.name != kNoName) entry.call = CallText(names_.Name(event.name), event.values, names_);
  if (event.kind == EventKind::kCall) {
    const Skill& skill = program_.skills[event.skill];
    entry.call = '(' + skill.spelling;
    for (std::size_t i = 0; i < event.values.size(); ++i) {
      const Value& value = event.values[i];
      entry.values.push_back(value.is_none() ? skill.variables[i] : ToString(value, names_));
      entry.call += ' ' + entry.values.back();
    }
    entry.call += ')';
  }
  if (event.kind == EventKind::kTop) {
    for (std::size_t i = 0; i < event.values.size(); ++i) {
      if (event.values[i].is_none()) continue;
      entry.bindings.emplace_back(variables[i], ToString(event.values[i], names_));
    }
  }
  return entry;
}

/// Where the clause stands and what it says.
void EventDescriber::SetClause(const Event& event, TraceEntry& entry) const {
  const bool stepping = event.kind == EventKind::kStep || event.kind == EventKind::kStepEnd;
  entry.form = stepping ? StepForm(event) : event.form;
  if (entry.form == kNoForm) return;
  const bool of_act = event.act != nullptr;
  const bool in_top = of_act ? event.act->path->caller == nullptr : event.body == kNoSkill;
  const SourceTree& source = in_top ? top_ : program_.source;
  if (!in_top) {
    entry.line = source.at(entry.form).line;
    entry.column = source.at(entry.form).column;
  }
  if (of_act) return;
  std::vector<Value> before(event.frame.begin(), event.frame.end());
  for (const Binding& binding : event.bindings) before[binding.variable] = Value();
  entry.clause = ClauseText(source, entry.form, {VariablesOf(event.body), before}, names_);
}

/// The step of a sequence that is asked; kNoForm after the last.
FormId EventDescriber::StepForm(const Event& event) const {
  const std::vector<Clause>* const steps = program_.skills[event.body].slot(Slot::kSequence);
  return event.index > steps->size() ? kNoForm : (*steps)[event.index - 1].form;
}

std::string TraceLine(const TraceEntry& entry) {
  std::string what = What(entry);
  if (what.empty()) return what;
  std::string place;
  if (entry.line != 0) place = std::to_string(entry.line) + ':' + std::to_string(entry.column);
  place.resize(std::max(kPlaceWidth, place.size() + 1), ' ');
  const std::size_t depth = entry.depth - (entry.kind == EventKind::kCall ? 1 : 0);
  return place + std::string(std::min(2 * depth, kMostIndent), ' ') + what;
}

}  // namespace latchwork::icarus

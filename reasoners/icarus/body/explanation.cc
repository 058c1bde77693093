// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/body/explanation.h"

#include <algorithm>
#include <utility>

#include "reasoners/icarus/language/signature.h"
#include "reasoners/icarus/language/walk.h"

namespace latchwork::icarus {

namespace {

constexpr unsigned kDeepest = 64;

const Clause* FindClause(const Skill& skill, FormId form) {
  const Clause* found = nullptr;
  WalkClauses(skill, [&](const Clause& clause, Slot) {
    if (clause.form == form) found = &clause;
  });
  return found;
}

/// Of a test that was True.
sdk::DerivationStep::Kind KindOfTest(const std::string& text) {
  const Signature* const builtin = FindBuiltin(text.substr(0, text.find('(')));
  const bool changes = builtin != nullptr && builtin->changes_memory;
  return changes ? sdk::DerivationStep::Kind::kMemoryChange
                 : sdk::DerivationStep::Kind::kArithmetic;
}

}  // namespace

Explanation::Explanation(const Program& program, TermBridge& bridge, const NamePool& names,
                         const ActCall& wanted, std::string conclusion)
    : program_(program),
      bridge_(bridge),
      names_(names),
      wanted_(wanted),
      conclusion_(std::move(conclusion)) {}

std::string Explanation::Text(const Value& value) const {
  logic::Term term;
  return bridge_.Export(value, term) ? logic::ToString(term) : ToString(value, names_);
}

/// In the syntax of terms; `f(x)` for a call and a list that begins with a name.
std::string Explanation::Text(const Term& term, std::span<const Value> frame) const {
  const auto arguments = [&](std::size_t first) {
    std::string text;
    for (std::size_t i = first; i < term.items.size(); ++i) {
      text += (i == first ? "(" : ", ") + Text(term.items[i], frame);
    }
    return text.empty() ? text : text + ')';
  };
  switch (term.kind) {
    case TermKind::kVariable:
      if (term.index < frame.size() && !frame[term.index].is_none()) return Text(frame[term.index]);
      return "X" + std::to_string(term.index);
    case TermKind::kCall:
      return logic::QuoteWord(term.text) + arguments(0);
    case TermKind::kList:
      if (!term.items.empty() && term.items[0].kind == TermKind::kSymbol) {
        return logic::QuoteWord(term.items[0].text) + arguments(1);
      }
      return "list" + arguments(0);
    case TermKind::kAnonymous:
      return "X";
    case TermKind::kInteger:
      return Text(Value::Integer(term.integer));
    case TermKind::kReal:
      return Text(Value::Real(term.real));
    default:
      return term.form == kNoForm ? term.text : logic::QuoteWord(program_.source.Text(term.form));
  }
}

std::string Explanation::ClauseText(const Event& event) const {
  const bool in_top = event.in == 0;
  const auto caller = calls_.find(event.in);
  const Skill& skill =
      in_top || caller == calls_.end() ? *program_.top : program_.skills[caller->second.skill];
  const Clause* clause = FindClause(skill, event.form);
  if (clause == nullptr) return {};
  std::string sign;
  while (!clause->inner.empty()) {
    sign += "~ ";
    clause = &clause->inner.front();
  }
  std::string name = "=";
  if (clause->kind == ClauseKind::kCall) return sign + Text(clause->terms[0], event.frame);
  if (clause->kind == ClauseKind::kSkill) {
    name = logic::QuoteWord(program_.skills[clause->skill].spelling);
  }
  const std::size_t first = clause->kind == ClauseKind::kMatch ? 1 : 0;
  if (first == 1) name = Text(clause->terms[0], event.frame);
  std::string text;
  for (std::size_t i = first; i < clause->terms.size(); ++i) {
    text += (i == first ? "" : ", ") + Text(clause->terms[i], event.frame);
  }
  if (clause->kind == ClauseKind::kBind) {
    return sign + Text(clause->terms[0], event.frame) + " = " + Text(clause->terms[1], event.frame);
  }
  return sign + name + (text.empty() ? "" : "(" + text + ")");
}

void Explanation::OnEvent(const Event& event) {
  switch (event.kind) {
    case EventKind::kCall:
      AddCall(event);
      break;
    case EventKind::kTrue:
      if (event.truth) AddFound(event, Kind::kSkill, ClauseText(event));
      break;
    case EventKind::kHost:
    case EventKind::kKnown:
      AddAnswer(event);
      break;
    case EventKind::kTest:
      if (event.truth) AddFound(event, KindOfTest(ClauseText(event)), ClauseText(event));
      answers_.clear();
      break;
    case EventKind::kBind:
      if (event.truth) AddFound(event, Kind::kBinding, ClauseText(event));
      answers_.clear();
      break;
    case EventKind::kMatch:
      if (event.truth) AddFound(event, Kind::kLatch, Text(event.answer));
      break;
    case EventKind::kNot:
      if (event.truth) AddFound(event, Kind::kNotTrue, ClauseText(event));
      break;
    case EventKind::kObjective:
      if (!event.truth) calls_[event.in].found.clear();
      break;
    case EventKind::kAct:
      if (IsWanted(*event.act)) acts_[event.act] = Derive(event.in);
      break;
    case EventKind::kChosen:
      if (chosen_.steps.empty() && acts_.contains(event.act)) chosen_ = acts_[event.act];
      break;
    default:
      break;
  }
}

void Explanation::AddCall(const Event& event) {
  answers_.clear();
  Call call;
  call.in = event.in;
  call.skill = event.skill;
  call.form = event.form;
  call.text = ClauseText(event);
  calls_[event.number] = std::move(call);
}

/// Clauses are asked in their order: what was found in later ones belongs to a way given up.
void Explanation::AddFound(const Event& event, Kind kind, std::string text) {
  Call& call = calls_[event.in];
  std::erase_if(call.found, [&](const Found& found) { return found.form >= event.form; });
  Found found;
  found.form = event.form;
  found.kind = kind;
  found.text = std::move(text);
  if (kind == Kind::kLatch) found.source = "memory";
  if (event.kind == EventKind::kTrue) {
    found.call = event.index;
    found.source = program_.skills[event.skill].spelling;
  }
  found.answers = std::move(answers_);
  answers_.clear();
  call.found.push_back(std::move(found));
}

/// `get_force(0.5, 1.0)`: inputs, then the answer, where it is more than true.
void Explanation::AddAnswer(const Event& event) {
  if (event.answer.is_none()) return;
  std::vector<Value> values(event.values.begin(), event.values.end());
  if (event.answer.kind == ValueKind::kList) {
    const auto items = event.answer.list->items();
    values.insert(values.end(), items.begin(), items.end());
  } else if (event.answer.kind != ValueKind::kSymbol || names_.Name(event.answer.name) != "t") {
    values.push_back(event.answer);
  }
  Found answer;
  answer.form = event.form;
  answer.kind = Kind::kAttachment;
  answer.source = names_.Name(event.name);
  answer.text = logic::QuoteWord(answer.source);
  for (std::size_t i = 0; i < values.size(); ++i) {
    answer.text += (i == 0 ? "(" : ", ") + Text(values[i]);
  }
  if (!values.empty()) answer.text += ')';
  answers_.push_back(std::move(answer));
}

bool Explanation::IsWanted(const Act& act) const {
  return std::any_of(act.calls.begin(), act.calls.end(), [&](const ActCall& call) {
    return call.function == wanted_.function &&
           std::equal(call.arguments.begin(), call.arguments.end(), wanted_.arguments.begin(),
                      wanted_.arguments.end(), Equal);
  });
}

std::size_t Explanation::AddStep(Kind kind, std::string text, std::string source, FormId form,
                                 std::vector<std::size_t> premises,
                                 sdk::Derivation& derivation) const {
  sdk::DerivationStep step;
  step.kind = kind;
  step.conclusion = std::move(text);
  step.source = std::move(source);
  if (form != kNoForm) step.place = program_.source.Place(form);
  step.premises = std::move(premises);
  derivation.steps.push_back(std::move(step));
  return derivation.steps.size() - 1;
}

std::vector<std::size_t> Explanation::AddSteps(const std::vector<Found>& found,
                                               sdk::Derivation& derivation, unsigned depth) {
  std::vector<std::size_t> steps;
  if (depth == kDeepest) return steps;
  for (const Found& each : found) {
    std::vector<std::size_t> premises = AddSteps(each.answers, derivation, depth + 1);
    const auto called = calls_.find(each.call);
    if (each.call != 0 && called != calls_.end()) {
      premises = AddSteps(called->second.found, derivation, depth + 1);
    }
    steps.push_back(
        AddStep(each.kind, each.text, each.source, each.form, std::move(premises), derivation));
  }
  return steps;
}

/// From the top down: each skill rests on the one that called it, with what was found there.
sdk::Derivation Explanation::Derive(std::uint32_t action) {
  std::vector<const Call*> path;
  for (auto at = calls_.find(action); at != calls_.end() && path.size() < 1000;
       at = calls_.find(at->second.in)) {
    path.push_back(&at->second);
  }
  std::reverse(path.begin(), path.end());
  sdk::Derivation derivation;
  if (path.empty()) return derivation;
  std::vector<std::size_t> premises;
  for (const Call* const call : path) {
    const std::size_t step =
        AddStep(Kind::kSkill, call->text, program_.skills[call->skill].spelling, call->form,
                std::move(premises), derivation);
    premises = AddSteps(call->found, derivation, 0);
    premises.insert(premises.begin(), step);
  }
  const Skill& skill = program_.skills[path.back()->skill];
  AddStep(Kind::kSkill, conclusion_, skill.spelling,
          skill.slot_forms[static_cast<std::size_t>(Slot::kAction)], std::move(premises),
          derivation);
  return derivation;
}

}  // namespace latchwork::icarus

// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reasoners/icarus/reference.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <set>

namespace latchwork::icarus::testing {

namespace {

constexpr std::size_t kMostClauses = 3'000;
constexpr double kNoValue = -std::numeric_limits<double>::infinity();

Datum Atom(std::string text) { return {std::move(text), {}, false}; }

/// A call of the skill with a variable for each parameter.
Clause OpenCall(const Program& program, std::uint32_t skill) {
  Clause call;
  call.kind = ClauseKind::kSkill;
  call.skill = skill;
  for (std::uint32_t i = 0; i < program.skills[skill].parameters; ++i) {
    Term variable;
    variable.kind = TermKind::kVariable;
    variable.index = i;
    call.terms.push_back(variable);
  }
  return call;
}

std::string Text(const std::vector<std::optional<Datum>>& environment) {
  std::string text;
  for (const auto& datum : environment) text += (datum ? datum->Text() : "?") + ' ';
  return text;
}

bool Fits(const Datum& pattern, const Datum& datum) {
  if (!pattern.is_list || !datum.is_list) return pattern.atom == "?" || pattern == datum;
  return std::equal(pattern.items.begin(), pattern.items.end(), datum.items.begin(),
                    datum.items.end(), Fits);
}

}  // namespace

std::string Datum::Text() const {
  if (!is_list) return atom;
  std::string text = "(";
  for (const Datum& item : items) text += (text.size() > 1 ? " " : "") + item.Text();
  return text + ")";
}

Reference::Reference(const Program& program, Answers answers, const RunOptions& options)
    : program_(program), answers_(std::move(answers)), options_(options) {
  for (const Term& fact : program.facts) memory_.push_back(*Evaluate(fact, {}));
}

std::string Reference::Memory() const {
  std::string text;
  for (const Datum& fact : memory_) text += fact.Text();
  return text;
}

void Reference::Cycle(std::uint32_t top) {
  ++cycle_;
  acts.clear();
  environments.clear();
  clauses = 0;
  depth_ = 0;
  double best = kNoValue;
  std::vector<std::vector<Change>> changes;
  Ask(OpenCall(program_, top), Environment(program_.skills[top].parameters), [&](const Outcome& o) {
    if (!o.is_act) {
      environments.push_back(Text(o.environment));
    } else if (options_.acts == ActMode::kAll) {
      if (std::find(acts.begin(), acts.end(), o.act) != acts.end()) return;
      acts.push_back(o.act);
      changes.push_back(o.changes);
    } else if (acts.empty() || (options_.acts == ActMode::kValue && o.value > best)) {
      acts = {o.act};
      changes = {o.changes};
      best = o.value;
    }
  });
  for (const std::vector<Change>& of_act : changes) {
    for (const Change& change : of_act) Apply(change);
  }
  std::set<std::uint32_t> called;
  for (const auto& [key, state] : states_) {
    if (state.touched == cycle_) called.insert(state_skills_[key]);
  }
  std::erase_if(states_, [&](const auto& entry) {
    return entry.second.touched != cycle_ && called.contains(state_skills_[entry.first]);
  });
}

void Reference::Apply(const Change& change) {
  const bool adds = change.function != "forget";
  const bool known =
      adds && std::find(memory_.begin(), memory_.end(), change.datum) != memory_.end();
  bool placed = !adds || known;
  std::vector<Datum> kept;
  for (const Datum& fact : memory_) {
    const bool fits = change.function != "store" && Fits(change.pattern, fact);
    const bool goes = fits && !(adds && fact == change.datum);
    if (!goes) kept.push_back(fact);
    if (goes && !placed) kept.push_back(change.datum);
    placed |= goes;
  }
  memory_ = kept;
  if (!placed) memory_.push_back(change.datum);
}

void Reference::Ask(const Clause& clause, const Environment& environment, const Emit& emit) {
  if (++clauses > kMostClauses) too_much = true;
  if (too_much) return;
  Environment bound = environment;
  switch (clause.kind) {
    case ClauseKind::kSkill:
      Call(clause, environment, emit);
      break;
    case ClauseKind::kCall:
      if (Evaluate(clause.terms[0], environment)) emit({false, environment, "", 0});
      break;
    case ClauseKind::kBind: {
      if (clause.terms[0].kind != TermKind::kVariable) {
        const std::optional<Datum> value = Evaluate(clause.terms[1], environment);
        if (value && Unify(clause.terms[0], *value, bound)) emit({false, bound, "", 0});
        break;
      }
      std::optional<Datum>& variable = bound[clause.terms[0].index];
      const std::optional<Datum> old = variable;
      if (old) {
        if (Unify(clause.terms[1], *old, bound)) emit({false, bound, "", 0});
        break;
      }
      variable = Evaluate(clause.terms[1], environment);
      if (variable) emit({false, bound, "", 0});
      break;
    }
    case ClauseKind::kMatch:
      Match(clause, environment, emit);
      break;
    case ClauseKind::kNot:
    case ClauseKind::kNotOrActing:
      Negation(clause, environment, emit);
  }
}

void Reference::Match(const Clause& clause, const Environment& environment, const Emit& emit) {
  const std::vector<Datum> snapshot = memory_;
  for (const Datum& fact : snapshot) {
    if (fact.items.size() != clause.terms.size()) continue;
    Environment bound = environment;
    bool matches = true;
    for (std::size_t i = 0; matches && i < fact.items.size(); ++i) {
      matches = Unify(clause.terms[i], fact.items[i], bound);
    }
    if (matches) emit({false, bound, "", 0});
  }
}

void Reference::Negation(const Clause& clause, const Environment& environment, const Emit& emit) {
  bool nothing = true;
  Ask(clause.inner[0], environment, [&](const Outcome& o) {
    nothing = false;
    if (o.is_act && clause.kind == ClauseKind::kNot) emit(o);
  });
  if (nothing) emit({false, environment, "", 0});
}

void Reference::Conjunction(const std::vector<Clause>& list, std::size_t first,
                            const Environment& environment, const Emit& emit) {
  if (first == list.size()) {
    emit({false, environment, "", 0});
    return;
  }
  Ask(list[first], environment, [&](const Outcome& o) {
    if (o.is_act) {
      emit(o);
    } else {
      Conjunction(list, first + 1, o.environment, emit);
    }
  });
}

void Reference::Call(const Clause& clause, const Environment& environment, const Emit& emit) {
  if (depth_ >= options_.max_depth) return;
  const Skill& skill = program_.skills[clause.skill];
  Environment frame(skill.variables.size());
  for (std::size_t i = 0; i < clause.terms.size(); ++i) {
    frame[i] = Evaluate(clause.terms[i], environment);
  }
  std::optional<double> own;
  if (options_.acts == ActMode::kValue && skill.value) {
    const std::optional<Datum> value = Evaluate(*skill.value, frame);
    if (value) own = std::strtod(value->atom.c_str(), nullptr);
  }
  std::vector<Outcome> kept;
  std::vector<Environment> seen;
  ++depth_;
  Body(clause.skill, frame, [&](const Outcome& o) {
    if (o.is_act) {
      kept.push_back(o);
      const bool passes =
          options_.acts == ActMode::kAll || (options_.acts == ActMode::kFirst && kept.size() == 1);
      const std::uint32_t inner = depth_--;
      if (passes) emit(kept.back());
      depth_ = inner;
      return;
    }
    Environment result = environment;
    for (std::size_t i = 0; i < clause.terms.size(); ++i) {
      const bool was_ground = Evaluate(clause.terms[i], environment).has_value();
      if (was_ground || !o.environment[i]) continue;
      if (!Unify(clause.terms[i], *o.environment[i], result)) return;
    }
    if (std::find(seen.begin(), seen.end(), result) != seen.end()) return;
    seen.push_back(result);
    const std::uint32_t inner = depth_--;
    emit({false, result, "", 0});
    depth_ = inner;
  });
  --depth_;
  if (options_.acts != ActMode::kValue || kept.empty()) return;
  Outcome best =
      *std::max_element(kept.begin(), kept.end(),
                        [](const Outcome& a, const Outcome& b) { return a.value < b.value; });
  if (own) best.value = *own;
  emit(best);
}

void Reference::Body(std::uint32_t index, const Environment& frame, const Emit& emit) {
  const Skill& skill = program_.skills[index];
  switch (skill.type) {
    case SkillType::kPlan:
      Plan(skill, frame, emit);
      break;
    case SkillType::kSequence:
      Sequence(index, frame, emit);
      break;
    case SkillType::kSensor:
      Conjunction(*skill.slot(Slot::kSensor), 0, frame, emit);
      break;
    case SkillType::kAction:
      Action(skill, frame, emit);
  }
}

void Reference::Plan(const Skill& skill, const Environment& frame, const Emit& emit) {
  bool any = false;
  if (skill.slot(Slot::kObjective) != nullptr) {
    Conjunction(*skill.slot(Slot::kObjective), 0, frame, [&](const Outcome& o) {
      any = true;
      emit(o);
    });
  }
  if (any) return;
  const std::vector<Clause> nothing;
  const std::vector<Clause>* required = skill.slot(Slot::kRequires);
  const std::vector<Clause>* means = skill.slot(Slot::kMeans);
  if (required == nullptr && means == nullptr) return;
  Conjunction(required == nullptr ? nothing : *required, 0, frame, [&](const Outcome& o) {
    if (o.is_act) {
      emit(o);
    } else if (means != nullptr) {
      for (const Clause& clause : Expanded(*means, o.environment)) {
        Ask(clause, o.environment, emit);
      }
    }
  });
}

std::vector<Clause> Reference::Expanded(const std::vector<Clause>& means,
                                        const Environment& environment) {
  std::vector<Clause> asked = means;
  if (options_.expansion == Expansion::kAll) return asked;
  if (options_.expansion == Expansion::kBest) {
    std::stable_sort(asked.begin(), asked.end(), [&](const Clause& a, const Clause& b) {
      return ValueOf(a, environment) > ValueOf(b, environment);
    });
  }
  asked.resize(std::min(asked.size(), options_.means));
  return asked;
}

double Reference::ValueOf(const Clause& means, const Environment& environment) {
  if (means.kind != ClauseKind::kSkill) return kNoValue;
  const Skill& skill = program_.skills[means.skill];
  if (!skill.value) return kNoValue;
  Environment frame(skill.variables.size());
  for (std::size_t i = 0; i < means.terms.size(); ++i) {
    frame[i] = Evaluate(means.terms[i], environment);
  }
  const std::optional<Datum> value = Evaluate(*skill.value, frame);
  return value ? std::strtod(value->atom.c_str(), nullptr) : kNoValue;
}

/// With every `?` as an atom.
std::optional<Datum> Reference::Pattern(const Term& term, const Environment& environment) {
  if (term.kind == TermKind::kAnonymous) return Atom("?");
  if (term.kind != TermKind::kList) return Evaluate(term, environment);
  Datum list;
  list.is_list = true;
  for (const Term& item : term.items) {
    const std::optional<Datum> value = Pattern(item, environment);
    if (!value) return std::nullopt;
    list.items.push_back(*value);
  }
  return list;
}

void Reference::Action(const Skill& skill, const Environment& frame, const Emit& emit) {
  Outcome outcome{true, frame, "", kNoValue};
  for (const Clause& clause : *skill.slot(Slot::kAction)) {
    const Term& call = clause.terms[0];
    const bool pattern = call.text == "forget" || call.text == "update";
    std::vector<Datum> values;
    outcome.act += '{' + call.text;
    for (const Term& item : call.items) {
      const bool open = pattern && values.empty();
      const std::optional<Datum> value = open ? Pattern(item, frame) : Evaluate(item, frame);
      if (!value) return;
      values.push_back(*value);
      outcome.act += ' ' + value->Text();
    }
    outcome.act += '}';
    if (pattern || call.text == "store") {
      outcome.changes.push_back({call.text, values.front(), values.back()});
    }
  }
  emit(outcome);
}

void Reference::Sequence(std::uint32_t index, const Environment& frame, const Emit& emit) {
  const Skill& skill = program_.skills[index];
  std::string key = skill.name;
  for (std::size_t i = 0; i < skill.parameters; ++i) {
    key += ' ' + (frame[i] ? frame[i]->Text() : std::string("?"));
  }
  if (!states_.contains(key)) states_[key] = {0, frame, 0};
  state_skills_[key] = index;
  if (states_[key].ended && states_[key].touched != cycle_) states_[key] = {0, frame, 0};
  states_[key].touched = cycle_;
  const std::vector<Clause>& steps = *skill.slot(Slot::kSequence);
  while (states_[key].step < steps.size()) {
    std::vector<Outcome> outcomes;
    Ask(steps[states_[key].step], states_[key].environment,
        [&](const Outcome& o) { outcomes.push_back(o); });
    const auto truth =
        std::find_if(outcomes.begin(), outcomes.end(), [](const Outcome& o) { return !o.is_act; });
    if (truth == outcomes.end()) {
      for (const Outcome& o : outcomes) emit(o);
      return;
    }
    states_[key].environment = truth->environment;
    ++states_[key].step;
  }
  states_[key].ended = options_.restart;
  emit({false, states_[key].environment, "", 0});
}

std::optional<Datum> Reference::Evaluate(const Term& term, const Environment& environment) {
  switch (term.kind) {
    case TermKind::kVariable:
      return environment[term.index];
    case TermKind::kAnonymous:
      return std::nullopt;
    case TermKind::kInteger:
      return Atom(std::to_string(term.integer));
    case TermKind::kCall:
      return Function(term, environment);
    case TermKind::kList: {
      Datum list;
      list.is_list = true;
      for (const Term& item : term.items) {
        const std::optional<Datum> value = Evaluate(item, environment);
        if (!value) return std::nullopt;
        list.items.push_back(*value);
      }
      return list;
    }
    default:
      return Atom(term.text);
  }
}

std::optional<Datum> Reference::Function(const Term& call, const Environment& environment) {
  if (call.text == "forget" || call.text == "update") {
    std::optional<Datum> fresh;
    if (call.text == "update") {
      fresh = Evaluate(call.items[1], environment);
      if (!fresh) return std::nullopt;
    }
    bool placed = !fresh || std::find(memory_.begin(), memory_.end(), *fresh) != memory_.end();
    std::vector<Datum> kept;
    for (const Datum& fact : memory_) {
      Environment bound = environment;
      const bool goes = Unify(call.items[0], fact, bound) && !(fresh && fact == *fresh);
      if (!goes) kept.push_back(fact);
      if (goes && !placed) kept.push_back(*fresh);
      placed |= goes;
    }
    memory_ = kept;
    if (!placed) memory_.push_back(*fresh);
    return Atom("t");
  }
  std::string text = call.text;
  std::vector<Datum> arguments;
  for (const Term& item : call.items) {
    const std::optional<Datum> value = Evaluate(item, environment);
    if (!value) return std::nullopt;
    arguments.push_back(*value);
    text += ' ' + value->Text();
  }
  if (call.text == "=") {
    return arguments[0] == arguments[1] ? std::optional(Atom("t")) : std::nullopt;
  }
  if (call.text == "store") {
    const bool known = std::find(memory_.begin(), memory_.end(), arguments[0]) != memory_.end();
    if (!known) memory_.push_back(arguments[0]);
    return Atom("t");
  }
  const std::string answer = answers_(text);
  return answer.empty() ? std::nullopt : std::optional(Atom(answer));
}

bool Reference::Unify(const Term& term, const Datum& datum, Environment& environment) {
  if (term.kind == TermKind::kAnonymous) return true;
  if (term.kind == TermKind::kVariable) {
    std::optional<Datum>& variable = environment[term.index];
    if (!variable) variable = datum;
    return *variable == datum;
  }
  if (term.kind != TermKind::kList) {
    const std::optional<Datum> value = Evaluate(term, environment);
    return value && *value == datum;
  }
  if (!datum.is_list || datum.items.size() != term.items.size()) return false;
  for (std::size_t i = 0; i < term.items.size(); ++i) {
    if (!Unify(term.items[i], datum.items[i], environment)) return false;
  }
  return true;
}

}  // namespace latchwork::icarus::testing

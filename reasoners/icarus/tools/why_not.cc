// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "reasoners/icarus/language/reader.h"
#include "reasoners/icarus/language/walk.h"
#include "reasoners/icarus/tools/body_place.h"
#include "reasoners/icarus/tools/why.h"

namespace latchwork::icarus {

namespace {

constexpr std::size_t kMostCalls = 3;   // Calls of one skill that are explained.
constexpr std::size_t kMostDepth = 20;  // Skills that a failure is followed through.

std::vector<std::string> Items(const std::string& list) {
  Findings findings;
  const SourceTree tree = ReadForms(list, "fact", findings);
  std::vector<std::string> items;
  if (tree.roots.size() != 1) return items;
  for (const FormId child : tree.Children(tree.roots[0])) items.emplace_back(tree.Text(child));
  return items;
}

bool Fit(const std::string& pattern, const std::string& item) {
  return pattern.starts_with('?') || item.starts_with('?') || Fold(pattern) == Fold(item);
}

/// The fact that a match form nearly matches, and why it does not.
std::string NearestFact(const std::string& clause, const std::vector<std::string>& memory) {
  const std::vector<std::string> wanted = Items(clause);
  if (wanted.empty()) return "";
  std::string nearest;
  std::size_t most = 0;
  bool known_head = false;
  std::vector<std::string> heads;
  for (const std::string& fact : memory) {
    const std::vector<std::string> items = Items(fact);
    if (items.empty()) continue;
    heads.push_back(Fold(items[0]));
    if (!Fit(wanted[0], items[0])) continue;
    known_head = true;
    std::size_t fitting = 0;
    for (std::size_t i = 0; i < std::min(items.size(), wanted.size()); ++i) {
      if (Fit(wanted[i], items[i])) ++fitting;
    }
    if (items.size() == wanted.size()) ++fitting;
    if (fitting > most) nearest = fact;
    most = std::max(most, fitting);
  }
  if (known_head) return "the nearest fact is " + nearest;
  const std::string_view other = logic::NearestName(Fold(wanted[0]), heads);
  std::string text = "no fact begins with " + wanted[0];
  if (!other.empty()) text += "; one begins with " + std::string(other);
  return text;
}

class Explainer {
 public:
  Explainer(const CycleRecord& cycle, const Program& program) : cycle_(cycle), program_(program) {}

  std::string Run(const CallPattern& pattern) {
    std::vector<const TraceEntry*> calls;
    for (const TraceEntry& entry : cycle_.entries) {
      if (entry.kind == EventKind::kCall && IsAsked(entry, pattern)) calls.push_back(&entry);
    }
    for (std::size_t i = 0; i < calls.size() && i < kMostCalls; ++i) Outcome(*calls[i], 0);
    if (calls.size() > kMostCalls) {
      text_ += "(" + std::to_string(calls.size() - kMostCalls) + " more calls)\n";
    }
    if (calls.empty()) NotCalled(pattern);
    return std::move(text_);
  }

 private:
  static bool IsAsked(const TraceEntry& call, const CallPattern& pattern) {
    return call.skill == pattern.skill &&
           std::equal(pattern.arguments.begin(), pattern.arguments.end(), call.values.begin(),
                      call.values.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                pattern.arguments.size(), call.values.size())),
                      Fit);
  }

  void Line(std::size_t indent, const std::string& text, const TraceEntry* at = nullptr) {
    text_ += std::string(2 * indent, ' ') + text;
    if (at != nullptr && at->line != 0) {
      text_ += "  [" + std::to_string(at->line) + ':' + std::to_string(at->column) + ']';
    }
    text_ += '\n';
  }

  const TraceEntry* Find(EventKind kind, std::uint32_t in) const {
    const auto found =
        std::find_if(cycle_.entries.begin(), cycle_.entries.end(),
                     [&](const TraceEntry& e) { return e.kind == kind && e.in == in; });
    return found == cycle_.entries.end() ? nullptr : &*found;
  }
  const TraceEntry* FindEnd(EventKind kind, std::uint32_t call) const {
    const auto found =
        std::find_if(cycle_.entries.begin(), cycle_.entries.end(),
                     [&](const TraceEntry& e) { return e.kind == kind && e.index == call; });
    return found == cycle_.entries.end() ? nullptr : &*found;
  }

  /// What a call came to.
  void Outcome(const TraceEntry& call, std::size_t indent) {
    const TraceEntry* const end = FindEnd(EventKind::kReturn, call.number);
    if (FindEnd(EventKind::kTrue, call.number) != nullptr) {
      Line(indent, call.call + " was called and is True", &call);
    } else if (end == nullptr) {
      const bool acted = Find(EventKind::kChosen, 0) != nullptr;
      Line(indent,
           call.call + " was called" +
               (acted ? " and acted" + ChosenText() : "; the cycle ended within it"),
           &call);
    } else if (end->acted) {
      Line(indent, call.call + " was called and acted" + ChosenText(), &call);
      Dropped(call, *end, indent + 1);
    } else {
      Line(indent, call.call + " was called and is False", &call);
      Failure(call, indent + 1);
    }
  }

  std::string ChosenText() const {
    const TraceEntry* const chosen = Find(EventKind::kChosen, 0);
    return chosen == nullptr ? "" : "; the act chosen is " + chosen->act;
  }

  /// The acts found in a call that went no further.
  void Dropped(const TraceEntry& call, const TraceEntry& end, std::size_t indent) {
    for (const TraceEntry& entry : cycle_.entries) {
      if (entry.kind != EventKind::kAct || entry.number < call.number ||
          entry.number > end.number) {
        continue;
      }
      const auto dropped = std::find_if(
          cycle_.entries.begin() + entry.number, cycle_.entries.end(),
          [&](const TraceEntry& e) { return e.kind == EventKind::kDropped && e.act == entry.act; });
      if (dropped == cycle_.entries.end()) continue;
      const std::string where = dropped->in == 0 ? "the top" : cycle_.entries[dropped->in - 1].call;
      Line(indent, "its act " + entry.act + " was dropped at " + where + " for another");
    }
  }

  static bool IsFailure(const TraceEntry& entry) {
    switch (entry.kind) {
      case EventKind::kTest:
      case EventKind::kBind:
      case EventKind::kMatch:
      case EventKind::kNot:
        return !entry.truth;
      case EventKind::kReturn:
        return !entry.truth && !entry.acted;
      default:
        return false;
    }
  }

  /// For each slot the clause that was come to last and failed.
  std::map<Slot, const TraceEntry*> Failures(const TraceEntry& call) const {
    const Skill& skill = program_.skills[call.skill];
    std::map<Slot, std::pair<BodyPlace, const TraceEntry*>> last;
    for (const TraceEntry& entry : cycle_.entries) {
      if (entry.in != call.number || !IsFailure(entry)) continue;
      const BodyPlace place = FindInBody(skill, entry.form);
      if (!place.found) continue;
      const auto [at, fresh] = last.try_emplace(place.slot, place, &entry);
      if (!fresh && !(place < at->second.first)) at->second = {place, &entry};
    }
    std::map<Slot, const TraceEntry*> failures;
    for (const auto& [slot, found] : last) failures[slot] = found.second;
    return failures;
  }

  void Failure(const TraceEntry& call, std::size_t indent) {
    const Skill& skill = program_.skills[call.skill];
    const auto failures = Failures(call);
    for (const auto& [slot, entry] : failures) {
      FailedClause(std::string(KeywordOf(slot)).substr(1), *entry, indent);
    }
    const bool asked_means = Find(EventKind::kMeans, call.number) != nullptr;
    if (skill.type == SkillType::kPlan && skill.slot(Slot::kMeans) == nullptr &&
        !failures.contains(Slot::kRequires)) {
      Line(indent, "it has no :means to act by");
    } else if (skill.type == SkillType::kAction) {
      Line(indent, "its act has an unbound variable");
    } else if (failures.empty() && !asked_means) {
      Line(indent, "nothing in it was asked");
    }
    Faults(call, indent);
  }

  void Faults(const TraceEntry& call, std::size_t indent) {
    for (const TraceEntry& entry : cycle_.entries) {
      if (entry.kind == EventKind::kFault && entry.in == call.number) {
        Line(indent, "fault: " + entry.text, &entry);
      }
    }
  }

  void FailedClause(const std::string& label, const TraceEntry& entry, std::size_t indent) {
    std::string text = label + ": " + entry.clause + " is False";
    if (entry.kind == EventKind::kMatch) text += "; " + NearestFact(entry.clause, cycle_.memory);
    if (entry.kind == EventKind::kNot) text += ": its clause is True or acts";
    if (entry.kind == EventKind::kTest || entry.kind == EventKind::kBind) text += Answers(entry);
    Line(indent, text, &entry);
    if (entry.kind == EventKind::kReturn && indent < kMostDepth) {
      Failure(cycle_.entries[entry.index - 1], indent + 1);
    }
  }

  /// What the host answered for a clause: the events just before it.
  std::string Answers(const TraceEntry& clause) const {
    std::string text;
    for (std::size_t i = clause.number - 1; i-- > 0;) {
      const TraceEntry& entry = cycle_.entries[i];
      if (entry.kind != EventKind::kHost && entry.kind != EventKind::kKnown) break;
      text.insert(0, ", " + entry.call + " = " + entry.answer.value_or("nil"));
    }
    if (!text.empty()) text.replace(0, 2, ": ");
    return text;
  }

  // The way to a skill that was not called.

  void NotCalled(const CallPattern& pattern) {
    const std::string name = program_.skills[pattern.skill].spelling;
    std::string with;
    for (const std::string& argument : pattern.arguments) with += ' ' + argument;
    Line(0, "(" + name + with + ") was not called");
    const TraceEntry* const top = Find(EventKind::kCall, 0);
    if (top == nullptr) return Line(1, "the top call was not asked in this cycle");
    if (!pattern.arguments.empty() && WasCalled(pattern.skill)) {
      return Line(1, "it was called with other arguments: why-not " + name);
    }
    const std::vector<std::uint32_t> way = Way(top->skill, pattern.skill);
    if (way.empty()) return Line(1, "no call leads to it from " + top->call);
    std::size_t last = 0;
    for (std::size_t i = 0; i < way.size(); ++i) last = WasCalled(way[i]) ? i : last;
    for (const TraceEntry& entry : cycle_.entries) {
      if (entry.kind == EventKind::kCall && entry.skill == way[last]) {
        return CutOff(entry, way[last + 1]);
      }
    }
  }

  bool WasCalled(std::uint32_t skill) const {
    return std::any_of(cycle_.entries.begin(), cycle_.entries.end(), [&](const TraceEntry& e) {
      return e.kind == EventKind::kCall && e.skill == skill;
    });
  }

  /// The shortest chain of calls from one skill to another.
  std::vector<std::uint32_t> Way(std::uint32_t from, std::uint32_t to) const {
    std::map<std::uint32_t, std::uint32_t> before = {{from, from}};
    std::deque<std::uint32_t> open = {from};
    while (!open.empty() && !before.contains(to)) {
      const std::uint32_t at = open.front();
      open.pop_front();
      WalkClauses(program_.skills[at], [&](const Clause& clause, Slot) {
        if (clause.kind != ClauseKind::kSkill) return;
        if (before.emplace(clause.skill, at).second) open.push_back(clause.skill);
      });
    }
    std::vector<std::uint32_t> way;
    if (!before.contains(to)) return way;
    for (std::uint32_t at = to; at != from; at = before.at(at)) way.push_back(at);
    way.push_back(from);
    std::reverse(way.begin(), way.end());
    return way;
  }

  /// Why a call did not come to its clause that calls `next`.
  void CutOff(const TraceEntry& call, std::uint32_t next) {
    const Skill& skill = program_.skills[call.skill];
    BodyPlace place;
    WalkClauses(skill, [&](const Clause& clause, Slot) {
      if (!place.found && clause.kind == ClauseKind::kSkill && clause.skill == next) {
        place = FindInBody(skill, clause.form);
      }
    });
    Line(1,
         "the way to it ends in " + call.call + ", whose " +
             std::string(KeywordOf(place.slot)).substr(1) + " calls " +
             program_.skills[next].spelling,
         &call);
    if (place.slot == Slot::kSequence) return AtStep(call, place);
    const TraceEntry* const objective = Find(EventKind::kObjective, call.number);
    if (place.slot != Slot::kObjective && objective != nullptr && objective->truth) {
      return Line(2, "its objective is not False, so that nothing else of it is asked");
    }
    const auto failures = Failures(call);
    const auto required = failures.find(place.slot == Slot::kMeans ? Slot::kRequires : place.slot);
    if (required != failures.end() && required->second != nullptr &&
        (place.slot == Slot::kMeans || FindInBody(skill, required->second->form) < place)) {
      return FailedClause(std::string(KeywordOf(required->first)).substr(1), *required->second, 2);
    }
    Line(2, "the cycle ended before it was come to" + ChosenText());
  }

  void AtStep(const TraceEntry& call, const BodyPlace& wanted) {
    const TraceEntry* step = nullptr;
    for (const TraceEntry& entry : cycle_.entries) {
      if (entry.kind == EventKind::kStep && entry.in == call.number) step = &entry;
    }
    if (step == nullptr) return;
    Line(2,
         step->clause.empty()
             ? "the sequence is finished"
             : "the sequence is at step " + std::to_string(step->index) + ", " + step->clause +
                   "; this is step " + std::to_string(wanted.index + 1),
         step);
  }

  const CycleRecord& cycle_;
  const Program& program_;
  std::string text_;
};

}  // namespace

std::string WhyNot(const CallPattern& pattern, const CycleRecord& cycle, const Program& program) {
  return Explainer(cycle, program).Run(pattern);
}

}  // namespace latchwork::icarus

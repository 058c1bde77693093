// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/tools/why.h"

#include "reasoners/icarus/tools/body_place.h"
#include "reasoners/icarus/tools/clause_text.h"
#include "reasoners/icarus/tools/world_script.h"

namespace latchwork::icarus {

namespace {

class PathText {
 public:
  PathText(const Program& program, const NamePool& names) : program_(program), names_(names) {}

  std::string Run(const Act& act) {
    std::vector<const PathSkill*> path;
    GetPath(act, path);
    text_ = ToString(act, names_) + '\n';
    for (std::size_t i = 0; i < path.size(); ++i) {
      Call(*path[i]);
      if (i + 1 < path.size()) Body(*path[i], path[i + 1]->form);
    }
    return std::move(text_);
  }

 private:
  void Call(const PathSkill& at) {
    const Skill& skill = program_.skills[at.skill];
    text_ += '(' + skill.spelling;
    for (std::size_t i = 0; i < at.arguments.size(); ++i) {
      const Value& value = at.arguments[i];
      text_ += ' ' + (value.is_none() ? skill.variables[i] : ToString(value, names_));
    }
    text_ += ")\n";
  }

  /// What held in a skill before it came to the clause at `form`.
  void Body(const PathSkill& at, FormId form) {
    const Skill& skill = program_.skills[at.skill];
    const BodyPlace place = FindInBody(skill, form);
    if (place.slot != Slot::kObjective && skill.slot(Slot::kObjective) != nullptr) {
      text_ += "  objective False:";
      for (const Clause& clause : *skill.slot(Slot::kObjective)) text_ += ' ' + InWords(at, clause);
      text_ += '\n';
    }
    if (place.slot == Slot::kMeans && skill.slot(Slot::kRequires) != nullptr) {
      for (const Clause& clause : *skill.slot(Slot::kRequires)) Line(at, "held", clause);
    }
    if (!place.found) return;
    const std::vector<Clause>& clauses = *skill.slot(place.slot);
    const bool ordered = place.slot == Slot::kObjective || place.slot == Slot::kRequires;
    for (std::size_t i = 0; ordered && i < place.index; ++i) Line(at, "held", clauses[i]);
    std::string label = std::string(KeywordOf(place.slot)).substr(1);
    if (!ordered) {
      label = (place.slot == Slot::kMeans ? "means " : "step ") + std::to_string(place.index + 1);
    }
    Line(at, label, clauses[place.index]);
  }

  void Line(const PathSkill& at, const std::string& label, const Clause& clause) {
    const Form& form = program_.source.at(clause.form);
    text_ += "  " + label + ": " + InWords(at, clause) + "  [" + std::to_string(form.line) + ':' +
             std::to_string(form.column) + "]\n";
  }

  std::string InWords(const PathSkill& at, const Clause& clause) const {
    const Skill& skill = program_.skills[at.skill];
    return ClauseText(program_.source, clause.form, {skill.variables, at.variables}, names_);
  }

  const Program& program_;
  const NamePool& names_;
  std::string text_;
};

}  // namespace

std::string Why(const Act& act, const Program& program, const NamePool& names) {
  return PathText(program, names).Run(act);
}

}  // namespace latchwork::icarus

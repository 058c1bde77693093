// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/top_check.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/logic/diagnostic.h"

namespace latchwork::icarus {

namespace {

void ReportNoSuchTop(const Program& program, const SourceTree& source, const Term& head,
                     Reporter& reporter) {
  std::vector<std::string> names;
  for (const Skill& skill : program.skills) names.push_back(skill.name);
  const std::string_view nearest = logic::NearestName(head.text, names);
  const std::string name(source.Text(head.form));
  std::string hint = "define it: (" + name + " () ...)";
  if (!nearest.empty()) {
    hint = "did you mean '" + program.skills[program.Find(nearest)].spelling + "'?";
  }
  reporter.Add(Code::kTop, head.form, "there is no skill '" + name + "'", std::move(hint));
}

}  // namespace

bool CheckTopCall(const Program& program, const SourceTree& source, const Clause& clause,
                  Reporter& reporter) {
  if (clause.kind == ClauseKind::kSkill) return true;
  if (clause.kind == ClauseKind::kMatch) {
    ReportNoSuchTop(program, source, clause.terms.front(), reporter);
  } else {
    reporter.Add(Code::kTop, clause.form, "the top of a program is one call of a skill",
                 "make a skill of it and call that: (Skill argument ...)");
  }
  return false;
}

bool CheckParameters(const Program& program, const Clause& call, Reporter& reporter) {
  const Skill& callee = program.skills[call.skill];
  if (call.terms.size() <= callee.parameters) return true;
  reporter.Add(Code::kTooManyArguments, call.form,
               "'" + callee.spelling + "' has " + std::to_string(callee.parameters) +
                   (callee.parameters == 1 ? " parameter" : " parameters") +
                   ", but is called with " + std::to_string(call.terms.size()),
               "take out what is too much");
  return false;
}

}  // namespace latchwork::icarus

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/top_check.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/logic/diagnostic.h"

namespace latchwork::icarus {

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

}  // namespace latchwork::icarus

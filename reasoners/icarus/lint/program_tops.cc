// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/lint/program_tops.h"

#include <cstddef>

#include "reasoners/icarus/language/walk.h"

namespace latchwork::icarus {

namespace {

std::vector<bool> Called(const Program& program) {
  std::vector<bool> called(program.skills.size(), false);
  for (std::size_t i = 0; i < program.skills.size(); ++i) {
    WalkClauses(program.skills[i], [&](const Clause& clause, Slot) {
      if (clause.kind == ClauseKind::kSkill && clause.skill != i) called[clause.skill] = true;
    });
  }
  return called;
}

}  // namespace

std::vector<std::uint32_t> TopsOf(const Program& program, const CheckOptions& options) {
  if (!options.top.empty()) return {program.Find(options.top)};
  if (program.top) {
    std::vector<std::uint32_t> named;
    WalkClauses(*program.top, [&](const Clause& clause, Slot) { named.push_back(clause.skill); });
    return named;
  }
  const std::vector<bool> called = Called(program);
  std::vector<std::uint32_t> tops;
  for (std::uint32_t i = 0; i < program.skills.size(); ++i) {
    if (i == 0 || !called[i]) tops.push_back(i);
  }
  return tops;
}

}  // namespace latchwork::icarus

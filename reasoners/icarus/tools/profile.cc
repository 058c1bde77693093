// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/tools/profile.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string_view>

namespace latchwork::icarus {

namespace {

constexpr std::size_t kColumn = 10;

std::string Right(std::string_view text) {
  const std::size_t width = std::max(text.size() + 1, kColumn);
  return std::string(width - text.size(), ' ') + std::string(text);
}

}  // namespace

void SkillProfile::OnEvent(const Event& event) {
  Counts* const body = event.body == kNoSkill ? nullptr : &counts_[event.body];
  switch (event.kind) {
    case EventKind::kCall:
      ++counts_[event.skill].calls;
      if (body != nullptr) ++body->clauses;
      break;
    case EventKind::kReturn:
      if (!event.truth && !event.acted) ++counts_[event.skill].falses;
      break;
    case EventKind::kTest:
    case EventKind::kBind:
    case EventKind::kNot:
    case EventKind::kMatch:
      if (event.index != 0) break;
      if (body != nullptr) ++body->clauses;
      break;
    case EventKind::kHost:
      if (body != nullptr) ++body->host;
      break;
    case EventKind::kAct:
      ++counts_[event.skill].acts;
      break;
    case EventKind::kChosen:
      ++counts_[event.skill].chosen;
      break;
    default:
      break;
  }
}

std::string SkillProfile::Table() const {
  std::vector<std::size_t> order(counts_.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return counts_[a].clauses > counts_[b].clauses;
  });
  std::string table;
  for (const std::string_view head : {"clauses", "calls", "false", "host", "acts", "chosen"}) {
    table += Right(head);
  }
  table += "  skill\n";
  for (const std::size_t i : order) {
    const Counts& at = counts_[i];
    for (const std::uint64_t n : {at.clauses, at.calls, at.falses, at.host, at.acts, at.chosen}) {
      table += Right(std::to_string(n));
    }
    table += "  " + program_.skills[i].spelling + '\n';
  }
  return table;
}

}  // namespace latchwork::icarus

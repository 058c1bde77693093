// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_DIFF_JOURNAL_H_
#define LATCHWORK_APPS_LATCHWORK_DIFF_JOURNAL_H_

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/latchwork/diff_theory.h"
#include "latchwork/plugin/registry.h"

namespace latchwork::app {

/// A decision of a recorded run on which contenders differ.
struct JournalDifference {
  std::uint64_t tick = 0;
  std::string layer;
  std::size_t contender = 0;  ///< That differs from the first.
  DiffTheory theory;
  Verdict first;
  Verdict other;
};

struct JournalReport {
  int exit_code = 0;
  std::string errors;
  std::uint64_t decisions = 0;  ///< That were compared.
  std::uint64_t undecided = 0;  ///< In which some contender was not done within its budget.
  std::vector<std::string> notes;
  std::vector<JournalDifference> differences;  ///< The first of each layer and contender.
};

/// Makes the run of a journal anew, and asks each contender what it would decide from the same
/// latches. Contenders keep what they keep from cycle to cycle.
JournalReport DiffJournal(const std::filesystem::path& journal,
                          const std::vector<Contender>& contenders,
                          const plugin::Registry& registry, logic::SymbolTable& symbols,
                          const std::function<void(std::uint64_t, std::uint64_t)>& notice);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_DIFF_JOURNAL_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_EPROVER_QUESTION_H_
#define LATCHWORK_EPROVER_QUESTION_H_

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::eprover {

/// The heuristic that E chooses for the problem.
inline constexpr std::string_view kAutomatic = "Auto";

/// How E is to search, and what one run of it may spend.
struct QuestionLimits {
  std::string heuristic{kAutomatic};
  std::uint64_t clauses = 5000;  ///< Processed; the logical limit.
  double seconds = 10;
  std::uint64_t memory_mb = 1024;
  std::optional<std::chrono::steady_clock::time_point> deadline;
  const std::atomic<bool>* cancelled = nullptr;
};

/// What one run of E said.
struct Reply {
  enum class End : std::uint8_t {
    kFound,          ///< As many answers as were asked for.
    kSaturated,      ///< There are no others.
    kContradiction,  ///< Of the axioms.
    kClauses,        ///< There may be others beyond the limit.
    kTime,
    kCancelled,
    kFailed,
  };
  End end = End::kFailed;
  std::vector<logic::Atom> answers;  ///< Instances of the pattern, maybe with variables.
  std::uint64_t processed = 0;       ///< Clauses.
  std::string problem;               ///< Of kFailed.
};

/// Asks for instances of a pattern that follow from the axioms; without one, whether these
/// contradict each other. Indefinite answers ("one of these") are none; E counts them, so that it
/// is asked again for more when it gave nothing else.
Reply Ask(const std::filesystem::path& program, std::string_view axioms, const logic::Atom* pattern,
          std::size_t answers, const QuestionLimits& limits, logic::SymbolTable& symbols);

}  // namespace latchwork::eprover

#endif  // LATCHWORK_EPROVER_QUESTION_H_

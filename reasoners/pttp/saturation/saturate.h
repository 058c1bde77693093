// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_SATURATE_H_
#define LATCHWORK_PTTP_SATURATION_SATURATE_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::pttp::saturation {

/// Which literals take part in inferences, when a clause has negative ones.
enum class Selection : std::uint8_t {
  kMaximal,       ///< No selection: the maximal literals.
  kLargest,       ///< The largest negative literal.
  kSmallest,      ///< The smallest negative literal.
  kUnlessUnique,  ///< The largest negative one, unless a positive one exceeds all others.
  kFirst,         ///< The first negative literal.
};

/// How the symbols of the term ordering compare.
enum class Precedence : std::uint8_t {
  kRareGreater,      ///< Fewer occurrences: greater.
  kFrequentGreater,  ///< More occurrences: greater.
  kArity,            ///< More arguments: greater; then fewer occurrences.
};

struct Options {
  Selection selection = Selection::kUnlessUnique;
  Precedence precedence = Precedence::kRareGreater;
  /// The most frequent unary function weighs nothing and exceeds all others (Knuth and Bendix's
  /// choice for groups).
  bool weightless_unary = false;
  /// Of so many given clauses in turn: the smallest by symbols, by symbols that count half when
  /// the goal has them, and the oldest.
  unsigned size_picks = 2;
  unsigned goal_picks = 4;
  unsigned age_picks = 1;
  /// Picks by goal symbols take descendants of the goal before all others.
  bool goal_first = false;
  /// Axioms among themselves make no inferences. Incomplete.
  bool set_of_support = false;
  /// Only formulas that share symbols with the goal over so many steps are used; 0: all.
  /// Incomplete where it leaves out any.
  unsigned relevance_depth = 0;
  /// With relevance_depth: a symbol brings in the formulas whose rarest symbol occurs at most this
  /// many times less often.
  unsigned relevance_tolerance = 1;
  /// Conclusions of more symbols are dropped; 0: none. Incomplete where it drops any.
  std::uint32_t max_size = 0;
  std::uint64_t max_inferences = std::numeric_limits<std::uint64_t>::max();
};

struct Problem {
  std::span<const logic::Clause> clauses;
  logic::SymbolTable& symbols;
};

struct Limits {
  std::size_t memory_bytes = std::size_t{1} << 30U;
  /// Asked often (every few conclusions); true ends the run. May be empty.
  const std::function<bool()>& stop;
};

enum class Status : std::uint8_t {
  kRefuted,
  kSaturated,   ///< No refutation exists: the clauses have a model.
  kGaveUp,      ///< Nothing is left to do, but something was left out on the way.
  kStopped,     ///< By the callback.
  kInferences,  ///< The limit on inferences.
  kMemory,      ///< The limit on memory.
};

/// One clause of a refutation, a consequence of its parents alone. Equality is built in.
struct Step {
  logic::Clause clause;
  std::string_view rule;             ///< "input" where `input` is set.
  std::optional<std::size_t> input;  ///< Index into Problem::clauses.
  std::vector<std::size_t> parents;  ///< Indices of earlier steps.
};

struct Statistics {
  std::uint64_t inferences = 0;  ///< Conclusions drawn.
  std::uint64_t kept = 0;        ///< Clauses that were remembered.
  std::uint64_t given = 0;
};

struct Outcome {
  Status status = Status::kGaveUp;
  std::vector<Step> proof;  ///< When refuted; the last step is the empty clause.
  Statistics statistics;
};

/// Looks for a refutation of clauses with equality by superposition, in a given-clause loop with
/// an active set that is kept simplified (DISCOUNT loop: Denzinger, Kronenburg, Schulz 1997).
/// Different numbers, and distinct objects, are unequal; other symbols with a fixed meaning
/// (`$less`) are taken as free, and kSaturated is not claimed where any of these occur. The same
/// input gives the same outcome, but for the moment when `stop` says true. One thread; nothing is
/// shared between calls but the symbol table, which is not changed.
Outcome Saturate(const Problem& problem, const Options& options, const Limits& limits);

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_SATURATE_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_DECISION_H_
#define LATCHWORK_SDK_DECISION_H_

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/clause.h"
#include "latchwork/sdk/undecided.h"

namespace latchwork::sdk {

/// What a reasoner may spend on one decision. The logical limits decide what it does, so that runs
/// repeat; the deadline is only set by the real-time scheduler and by tools. A reasoner polls
/// `cancelled` and the deadline at least every millisecond of work.
struct Budget {
  std::uint64_t inferences = 1'000'000;
  std::uint32_t depth = 64;
  std::optional<std::chrono::steady_clock::time_point> deadline;
  const std::atomic<bool>* cancelled = nullptr;
};

/// Which limit cut a search short.
enum class Limit : std::uint8_t { kNone, kInferences, kDepth, kTime, kCancelled };

enum class Status : std::uint8_t {
  kProved,   ///< Every goal was decided, at least one was proved.
  kRefuted,  ///< Every goal was decided, none can be proved: 'no'.
  kUnknown,  ///< A limit ran out before a goal was decided: 'no time'; or, with Limit::kNone, some
             ///< goal is undecided. Conclusions found so far are given and sound.
  kInconsistent,  ///< Body and latches contradict each other; nothing is concluded.
  kFailed,        ///< The reasoner could not work: `message` says why; nothing is concluded.
};

/// A default of a minimized predicate: "not `atom`", as far as it was asked for in this decision.
struct Assumption {
  enum class State : std::uint8_t {
    kMade,         ///< `atom` finitely failed: assumed false.
    kMadeByBound,  ///< `atom` was not proved within the bound: assumed false, which may be wrong.
    kRetracted,    ///< `atom` was proved: the default does not hold now.
  };
  logic::Fact atom;
  State state = State::kMade;
  friend bool operator==(const Assumption&, const Assumption&) = default;
};

/// A proved instance of a goal.
struct Conclusion {
  std::size_t goal = 0;  ///< Index into the goals of the body.
  logic::Fact fact;
  std::vector<std::size_t> assumptions;  ///< What it rests on: indices into Decision::assumptions.
};

/// Counted as the literature does: extension and reduction steps that succeed.
struct Statistics {
  std::uint64_t inferences = 0;
  std::uint32_t depth = 0;  ///< Of the deepest proof found.
  std::uint64_t attachment_calls = 0;
};

/// The outcome of one cycle. Reused from cycle to cycle so that nothing is allocated after warm-up.
struct Decision {
  Status status = Status::kFailed;
  Limit limit = Limit::kNone;
  std::vector<Conclusion> conclusions;  ///< By goal, then in the order of discovery.
  /// Instances of goals that are neither proved nor refuted, as far as the reasoner knows.
  std::vector<Conclusion> undecided;
  std::vector<GoalState> states;  ///< The joint states that `undecided` may be in; empty: any.
  std::vector<Assumption> assumptions;
  Statistics statistics;
  std::string message;

  void Clear();
};

/// A step of a derivation. Premises are indices of earlier steps.
struct DerivationStep {
  enum class Kind : std::uint8_t {
    kClause,
    kLatch,
    kAssumption,
    kAttachment,
    kArithmetic,
    kReduction,
    kSkill,
    kNotTrue,
    kBinding,
    kMemoryChange
  };
  Kind kind = Kind::kClause;
  std::string conclusion;  ///< A literal in TPTP syntax.
  std::string source;      ///< Name of the clause, skill, latch port or attachment; may be empty.
  logic::SourcePlace place;
  std::vector<std::size_t> premises;
};

/// How a conclusion came about; the last step concludes it. Empty when the reasoner keeps none.
struct Derivation {
  std::vector<DerivationStep> steps;
};

std::string_view Name(Status status);
std::string_view Name(Limit limit);
std::string_view Name(Assumption::State state);

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_DECISION_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_MACHINE_H_
#define LATCHWORK_PTTP_MACHINE_H_

#include <cstdint>
#include <vector>

#include "reasoners/pttp/plans/situations.h"
#include "reasoners/pttp/search/failure_cache.h"
#include "reasoners/pttp/search/meter.h"
#include "reasoners/pttp/search/oracles.h"
#include "reasoners/pttp/terms/arena.h"
#include "reasoners/pttp/terms/calculator.h"
#include "reasoners/pttp/terms/unifier.h"
#include "reasoners/pttp/theory/facts.h"
#include "reasoners/pttp/theory/predicates.h"
#include "reasoners/pttp/theory/program.h"
#include "reasoners/pttp/theory/reach.h"

namespace latchwork::pttp {

/// A subgoal that was selected: a node of the tableau. Its ancestors are the goals that led to it.
struct Node {
  const CompiledLiteral* literal;
  Word* arguments;
  const Node* parent;
  std::uint32_t remaining;  ///< How many rules may still follow each other below it.
  std::uint32_t choice;     ///< Its place on the stack of choices.
  bool ground;
};

/// How a node was closed; recorded on request only. The newest comes first.
struct Step {
  enum class Kind : std::uint8_t {
    kRule,
    kFact,
    kReduction,
    kEquality,
    kArithmetic,
    kAttachment,
    kAssumption,
  };
  Kind kind = Kind::kRule;
  const Node* node = nullptr;
  const Contrapositive* rule = nullptr;  ///< kRule.
  Word* slots = nullptr;                 ///< kRule: its variables.
  const FactSource* source = nullptr;    ///< kFact.
  const Step* previous = nullptr;
};

/// An assumption that the current partial proof rests on. The newest comes first.
struct Resting {
  const Resting* previous;
  std::size_t assumption;
};

/// A proof of the start goals. Valid until the sink returns.
struct Proof {
  const Contrapositive* start;
  const Word* slots;  ///< Variables of the start clause.
  const Resting* resting;
  const Step* steps;
  std::uint32_t depth;
};

class ProofSink {
 public:
  virtual ~ProofSink() = default;
  /// True: enough.
  virtual bool Accept(const Proof& proof) = 0;
};

struct SearchRequest {
  std::vector<const Contrapositive*> starts;  ///< Tried in this order on every level.
  const Reach* reach = nullptr;
  Situations* situations = nullptr;  ///< Where fluents are looked up; the reach is theirs.
  std::uint32_t depth = 64;
  bool record = false;
};

enum class SearchEnd : std::uint8_t {
  kAccepted,      ///< The sink had enough.
  kExhausted,     ///< There are no other proofs.
  kDepth,         ///< There may be proofs beyond the depth bound.
  kUndetermined,  ///< A literal never became ground, or could not be closed.
  kDoubtful,      ///< Situations that were not looked at may make a difference.
  kStopped,       ///< The meter ran out.
};

/// What all searches of one engine share.
struct Workshop {
  const Predicates* predicates = nullptr;
  const FactStore* facts = nullptr;
  Functors* functors = nullptr;
  Arena* heap = nullptr;
  Meter* meter = nullptr;
  FailureCache* failures = nullptr;
  Oracles* oracles = nullptr;
  bool unique_names = false;
  bool reorder = true;
};

/// Model elimination (Loveland 1968; Stickel 1988) by iterative deepening on the length of paths:
/// extension with contrapositives and facts, reduction against ancestors where the theory is not
/// Horn, pruning of goals that repeat an ancestor there, and of goals known to fail where it is.
/// Facts, units, reductions and computed literals are not charged. An abstract machine with
/// explicit stacks: nothing recurses.
class Machine {
 public:
  explicit Machine(const Workshop& workshop);

  SearchEnd Search(const SearchRequest& request, ProofSink& sink);

  /// Why the last search was undetermined: the literal's predicate that never became ground; else
  /// none.
  bool floundered() const { return floundered_; }
  PredicateId floundered_predicate() const { return floundered_predicate_; }

 private:
  struct Activation;
  struct Continuation {
    const Activation* activation;
    std::uint64_t mask;  ///< Which of the 64 body literals from `base` on are still to be proved.
    std::uint32_t base;
  };
  struct Activation {
    const Contrapositive* rule;
    Word* slots;
    const Node* node;  ///< That the rule was applied to; null for the start clause.
    Continuation next;
    std::uint32_t remaining;
  };
  struct Delayed {
    const CompiledLiteral* literal;
    const Activation* activation;
    const Delayed* next;
  };
  enum class Phase : std::uint8_t {
    kEquality,
    kReduction,
    kSituations,
    kFacts,
    kComputed,
    kRules,
    kClosing,
    kDone
  };
  struct Choice {
    Arena::Mark heap;
    std::size_t trail = 0;
    Continuation continuation{};
    const Delayed* delayed = nullptr;
    const Resting* resting = nullptr;
    const Step* steps = nullptr;
    const Node* node = nullptr;
    const Node* ancestor = nullptr;
    Computed* computed = nullptr;
    FactTable::Cursor cursor;
    std::uint32_t table = 0;
    std::uint32_t rule = 0;
    std::uint32_t entry = 0;
    std::uint32_t depth = 0;
    std::uint32_t question = kNoEntry;
    std::uint32_t chosen = 0;      ///< How many choices the partial proof rests on.
    std::uint64_t all_chosen = 0;  ///< How many there have been.
    Phase phase = Phase::kEquality;
    bool proved = false;
    bool cut = false;
    bool cacheable = false;
  };
  struct Selected {
    const CompiledLiteral* literal;
    const Activation* activation;
  };
  enum class Selection : std::uint8_t { kGoal, kProof, kStuck };

  SearchEnd RunStart(const Contrapositive& start, ProofSink& sink);
  void BeginLevel(std::uint32_t depth);
  void Begin(const Contrapositive& start);
  bool LevelIsComplete() const;

  // Selection of subgoals (machine_select.cc).
  Selection Select();
  bool SelectDelayed();
  bool SelectFrom(const Activation& activation);
  int FindEager(const Activation& activation) const;
  int FindExtensional(const Activation& activation) const;
  void Leave(const Activation& activation);
  bool IsReady(const CompiledLiteral& literal, const Activation& activation) const;
  std::uint64_t Needs(const CompiledLiteral& literal) const;
  bool HasRules(const CompiledLiteral& literal) const;

  // Solving of the selected subgoal.
  bool Call();
  Node* MakeNode();
  bool CallArithmetic(const Node& node);
  bool CallOrdinary(Node& node);
  bool RepeatsAncestor(const Node& node);
  bool Resume();
  bool TryPhase(Choice& choice);
  bool TryEquality(Choice& choice);
  bool TryReduction(Choice& choice);
  bool TrySituations(Choice& choice);
  bool FindInstance(Choice& choice, Situations::Instance& instance);
  bool Instantiate(Choice& choice, const Situations::Instance& instance);
  bool TryFacts(Choice& choice);
  bool TryComputed(Choice& choice);
  bool TryRules(Choice& choice);
  bool TryClosing(Choice& choice);
  bool Extend(Choice& choice, const Contrapositive& rule);
  void Retreat(const Choice& choice);
  bool SolvedAtOnce(Choice& choice, const Step& step);
  bool Proceed();
  void Fail(Choice& choice);
  void NoteCut(std::uint32_t entry);
  void CheckMemory();
  void Record(const Step& step);
  void RestOn(std::size_t assumption);

  Workshop shop_;
  mutable Unifier unifier_;
  Calculator calculator_;
  const Reach* reach_ = nullptr;
  Situations* situations_ = nullptr;
  bool record_ = false;

  Continuation continuation_{};
  const Delayed* delayed_ = nullptr;
  const Resting* resting_ = nullptr;
  const Step* steps_ = nullptr;
  std::uint32_t depth_ = 0;
  std::uint32_t chosen_ = 0;      ///< Choices of situations that the partial proof rests on.
  std::uint64_t all_chosen_ = 0;  ///< Those of the level.
  Selected selected_{};
  std::vector<Choice> choices_;

  std::uint32_t level_depth_ = 0;
  std::uint64_t level_ = 0;
  bool cut_ = false;
  std::vector<std::uint32_t> cut_goals_;
  bool floundered_ = false;
  bool undetermined_ = false;
  PredicateId floundered_predicate_ = 0;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_MACHINE_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLES_H_
#define LATCHWORK_PTTP_TABLES_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "reasoners/pttp/arena.h"
#include "reasoners/pttp/calculator.h"
#include "reasoners/pttp/facts.h"
#include "reasoners/pttp/machine.h"
#include "reasoners/pttp/meter.h"
#include "reasoners/pttp/oracles.h"
#include "reasoners/pttp/row_set.h"
#include "reasoners/pttp/table_plan.h"
#include "reasoners/pttp/unifier.h"

namespace latchwork::pttp {

/// Answers queries by tables: every call of a predicate with rules, told apart by its ground
/// arguments, is solved once per decision, and its answers are kept (Tamaki and Sato 1986; Chen and
/// Warren 1996). Calls of predicates that do not lead to themselves are solved in full before their
/// answers are used. Within a recursive component a call's consumers are resumed with each new
/// answer until there are none (semi-naive), which ends on cyclic data, since recursive rules make
/// no new terms (see TableProgram).
///
/// Sound: an answer is entered only when a rule's head is an instance of the call and its body was
/// solved by facts, answers, computed literals or closings; so it has a proof by extension steps
/// alone. Complete: without reduction steps, and with every answer ground, a literal's solutions do
/// not depend on what surrounds it, so solving calls apart loses none (Horn, least model).
class Tables {
 public:
  explicit Tables(const Workshop& shop);

  /// Forgets all answers and keeps the memory.
  void Begin();
  /// Hands every solution of a query to the sink until it has enough. Nothing: the query turned out
  /// not to fit; what was handed out stands, but there may be more.
  /// `given`: values for all variables, or nothing.
  std::optional<SearchEnd> Solve(TableProgram& program, const TablePlan& query,
                                 std::span<const Word> given, ProofSink& sink);

 private:
  enum class State : std::uint8_t { kOpen, kComplete, kBroken };
  struct Origin {
    const Resting* resting;
    std::uint32_t depth;
  };
  /// A call and its answers.
  struct Table {
    explicit Table(std::size_t arity) : rows(arity) {}
    FactTable rows;
    std::vector<Origin> origins;  ///< By row.
    std::vector<std::uint32_t> consumers;
    const Word* arguments = nullptr;  ///< Ground, or a free word.
    std::uint64_t ground = 0;
    std::uint32_t key = 0;
    std::uint32_t number = 0;
    std::size_t label = 0;  ///< `key` and closing.
    State state = State::kOpen;
  };
  /// One Solve.
  struct Run {
    TableProgram* program = nullptr;
    ProofSink* sink = nullptr;
    bool enough = false;
    bool unfit = false;
  };
  /// A body that is being solved.
  struct Frame {
    Run* run;
    const TablePlan* plan;
    Table* target;  ///< Null for the query.
    Word* slots;
    const Resting* resting;
    std::uint32_t depth;
  };
  struct Consumer {
    Frame frame;
    std::size_t step;
    const Table* source;
    std::uint32_t next;
    bool queued;
  };
  /// What is still to be done in a component: a new table, or a consumer with new answers.
  struct Task {
    Table* table;
    std::uint32_t consumer;
  };

  // All return false when the run is to end.
  bool Continue(const Frame& frame, std::size_t step);
  bool TryFacts(const Frame& frame, std::size_t step);
  bool TryCall(const Frame& frame, std::size_t step);
  bool TryComputed(const Frame& frame, std::size_t step);
  bool TryClosing(const Frame& frame, std::size_t step);
  bool TryUnify(const Frame& frame, std::size_t step);
  bool Holds(const Frame& frame, const TableStep& step);
  bool TryRows(const Frame& frame, std::size_t step, FactTable& rows,
               std::span<const Origin> origins, const Word* goal);
  bool TryRow(const Frame& frame, std::size_t step, const Word* row, const Origin& origin,
              const Word* goal);
  bool Deliver(const Frame& frame);
  /// False when it is known already.
  bool Enter(Table& table, const Word* row, const Origin& origin);
  bool Evaluate(Run& run, Table& table);
  bool EvaluateFacts(Table& table);
  bool EvaluateComponent(Run& run, Table& table);
  bool Resume(std::uint32_t consumer);
  bool Unfit(Run& run);

  Table* FindTable(Run& run, const TableStep& step, const Word* goal, bool& added);
  Table* MakeTable(const TableStep& step, std::size_t label, const Word* goal);
  bool IsCall(const Table& table, const TableStep& step, std::size_t label, const Word* goal);
  void Subscribe(const Frame& frame, std::size_t step, Table& table);
  void CloseTables(std::size_t first, State state);

  const Word* MakeGoal(const TableStep& step, const Word* slots);
  bool Matches(const TableStep& step, const Word* row, const Word* goal, Word* slots);
  bool Match(Word pattern, Word value, Word* slots);
  bool AreSame(Word a, Word b) { return a == b || (TagOf(a) == TagOf(b) && AreSameWithin(a, b)); }
  bool AreSameWithin(Word a, Word b);
  Word* MakeSlots(std::size_t count);
  Word Keep(Word word);
  std::optional<Word> Value(const TableStep& step, std::size_t argument, const Word* slots,
                            Calculator& calculator, Unifier& builder);
  Word BuildGround(Word pattern, const Word* slots, Unifier& builder) {
    if (TagOf(pattern) == Tag::kSlot) return slots[NumberOf(pattern)];
    return TagOf(pattern) == Tag::kTemplate ? builder.Build(pattern, slots) : pattern;
  }
  const Resting* Join(const Resting* a, const Resting* b);
  bool Count();

  Workshop shop_;
  Arena store_;  ///< What lasts for the decision.
  Arena stack_;  ///< What lasts for a step.
  Unifier keeper_;
  Unifier builder_;
  Calculator keeping_calculator_;
  Calculator calculator_;
  std::array<Word, 32> free_{};  ///< Unbound variables for arguments of calls.

  RowSet calls_;
  RowSet answers_;
  std::vector<Table*> tables_;  ///< By number.
  struct Answer {
    const Table* table;
    std::uint32_t row;
  };
  std::vector<Answer> all_answers_;  ///< By number.
  std::vector<Table*> general_;  ///< By signed predicate and closing: the call that binds nothing.
  std::vector<std::vector<std::unique_ptr<Table>>> pools_;  ///< By arity.
  std::vector<std::size_t> used_;                           ///< Of the pools.
  std::vector<Table*> open_;
  std::vector<Consumer> consumers_;
  std::vector<Task> agenda_;
  std::size_t nesting_ = 0;
  struct Copy {
    const Word* from;
    Word* to;
  };
  std::vector<Copy> copies_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLES_H_

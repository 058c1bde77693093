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
#include "reasoners/pttp/table_code.h"
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
    TableCall* call = nullptr;
    const Word* arguments = nullptr;  ///< Those that are ground; others mean nothing.
    std::uint32_t number = 0;
    State state = State::kOpen;

    /// There can be no other answers.
    bool IsFull() const { return call->whole && rows.rows() > 0; }
  };
  /// One Solve.
  struct Run {
    TableProgram* program = nullptr;
    ProofSink* sink = nullptr;
    bool enough = false;
    bool unfit = false;
  };
  /// A body that is being solved.
  struct Body {
    Run* run;
    const TablePlan* plan;
    Table* target;  ///< Null for the query.
    Word* slots;
  };
  /// How far it is solved.
  struct Place {
    const Body* body;
    std::size_t step;  ///< The next one.
    const Resting* resting;
    std::uint32_t depth;
  };
  struct Consumer {
    Body body;
    Place place;
    const Table* source;
    std::uint32_t next;
    bool queued;
  };
  /// What is still to be done in a component: a new table, or a consumer with new answers.
  struct Task {
    Table* table;
    std::uint32_t consumer;
  };
  enum class Outcome : std::uint8_t { kHolds, kFails, kEnds };
  /// Where values are made.
  struct Maker {
    explicit Maker(const Functors& functors) : calculator(functors, arena) {}
    Arena arena;
    Calculator calculator;
  };

  // What returns a bool returns false when the body is to be left: its run is to end, or its target
  // is full.
  bool Continue(Place at);
  bool Enumerate(const Place& at, const TableStep& step);
  bool TryFacts(const Place& at, const TableStep& step, const Word* values);
  bool TryCall(const Place& at, const TableStep& step, const Word* values);
  bool TryComputed(const Place& at, const TableStep& step, const Word* values);
  bool TryRows(const Place& at, const TableStep& step, FactTable& rows, const Origin* origins,
               const Word* values);
  Outcome Close(Place& at, const TableStep& step);
  Outcome Unify(const Body& body, const TableStep& step);
  bool Deliver(const Place& at);
  bool Evaluate(Run& run, Table& table);
  bool EvaluateRule(const Body& body);
  void EvaluateFacts(Table& table);
  bool EvaluateComponent(Run& run, Table& table);
  bool Resume(std::uint32_t consumer);
  bool Unfit(Run& run);
  bool HasEnded(const Run& run) const {
    return run.enough || run.unfit || shop_.meter->stopped();
  }

  /// False when it is known already.
  bool Enter(Table& table, const Word* row, const Origin& origin);
  bool IsNew(const Table& table, const Word* row);
  Table* FindTable(const TableStep& step, const Word* values, bool& added);
  Table* MakeTable(const TableStep& step, const Word* values);
  Table* TakeTable(std::size_t arity);
  bool IsCall(const Table& table, const TableStep& step, const Word* values);
  void Subscribe(const Place& at, Table& table);
  void CloseTables(std::size_t first, State state);

  // Terms and numbers (table_terms.cc).
  bool Holds(const TableStep& step, const Word* slots);
  bool Agrees(const TableStep& step, const Word* values, const Word* row);
  bool Match(const Pattern& pattern, const Word* given, Word* slots);
  bool AreSame(Word a, Word b) { return a == b || (TagOf(a) == TagOf(b) && AreSameWithin(a, b)); }
  bool AreSameWithin(Word a, Word b);
  Word Keep(Word word);
  bool ReadNumber(const Operand& operand, const Word* slots, Number& number);
  bool Calculate(const Operand& operand, const Word* slots, Number& number);
  bool Mix(const Operand& operand, const Word* slots, Number& number);
  bool MakeMixed(const Operand& operand, const Word* slots, Maker& maker, Word& value);
  bool MakeValue(const Operand& operand, const Word* slots, Maker& maker, Word& value);
  bool MakeValues(const TableStep& step, const Word* slots, Word* values);
  const Resting* Join(const Resting* a, const Resting* b);
  bool Count() {
    shop_.meter->CountWork();
    return !shop_.meter->stopped();
  }

  Workshop shop_;
  Maker store_;  ///< What lasts for the decision.
  Maker stack_;  ///< What lasts for a step.
  Unifier comparer_;
  std::array<Word, 32> free_{};  ///< Unbound variables for arguments of attachments.
  std::array<Number, kDeepestTemplate + 2> numbers_{};  ///< Of a calculation.

  RowSet calls_;
  RowSet answers_;
  std::vector<Table*> tables_;  ///< By number.
  struct Answer {
    const Table* table;
    std::uint32_t row;
  };
  std::vector<Answer> all_answers_;  ///< By number.
  std::vector<Table*> general_;      ///< By label: the call that binds nothing.
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

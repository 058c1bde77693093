// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLES_H_
#define LATCHWORK_PTTP_TABLES_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <vector>

#include "reasoners/pttp/search/machine.h"
#include "reasoners/pttp/search/meter.h"
#include "reasoners/pttp/search/oracles.h"
#include "reasoners/pttp/tables/table_code.h"
#include "reasoners/pttp/tables/table_plan.h"
#include "reasoners/pttp/terms/arena.h"
#include "reasoners/pttp/terms/calculator.h"
#include "reasoners/pttp/terms/row_set.h"
#include "reasoners/pttp/terms/term_copier.h"
#include "reasoners/pttp/terms/unifier.h"
#include "reasoners/pttp/theory/facts.h"

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
  };
  /// A partial solution of a body. Its slots follow it.
  struct Binding {
    const Resting* resting;
    std::size_t depth;  ///< Of the deepest proof in it.
    Word* slots() { return std::launder(reinterpret_cast<Word*>(this + 1)); }
  };
  /// Solutions of the same steps, in the order of the rows that gave them.
  struct Batch {
    static constexpr std::size_t kMost = 64;
    Binding** bindings = nullptr;
    std::size_t count = 0;
  };
  /// Where a step puts the bindings that it extends.
  struct Output {
    const Body* body = nullptr;
    std::size_t step = 0;  ///< That goes on with them.
    Batch batch = {};
    Arena::Mark mark = {};  ///< What lies above goes when they are done with.
  };
  struct Consumer {
    Body body;
    std::size_t step;
    Binding* binding;
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
  bool Proceed(const Body& body, std::size_t step, Batch batch);
  bool Filter(const TableStep& step, Batch& batch);
  bool Join(const Body& body, std::size_t step, const Batch& batch);
  bool OneByOne(const Body& body, std::size_t step, const Batch& batch);
  bool Deliver(const Body& body, const Batch& batch);
  bool DeliverAnswer(const Body& body, Binding& binding);
  /// A table where a step finds one row at most; null when there may be others.
  FactTable* FindLookup(const TableStep& step, const Origin*& origins);
  FactTable* OnlyFacts(PredicateId predicate) const;
  bool Lookup(const TableStep& step, FactTable& rows, const Origin* origins, Batch& batch);
  bool LookupRow(const TableStep& step, FactTable& rows, const Origin* origins, Binding& binding);
  bool Flush(Output& output);
  bool Extend(const TableStep& step, Binding& binding, Output& output);
  bool ExtendByFacts(const TableStep& step, const Word* values, Binding& binding, Output& output);
  bool ExtendByCall(const TableStep& step, const Word* values, Binding& binding, Output& output);
  bool ExtendByComputed(const TableStep& step, const Word* values, Binding& binding,
                        Output& output);
  /// `last`: nothing else will extend the binding.
  bool ExtendByRows(const TableStep& step, const Word* values, FactTable& rows,
                    const Origin* origins, bool last, Binding& binding, Output& output);
  bool Complete(Run& run, Table& table);
  bool Unify(const TableStep& step, Word* slots);
  Outcome Close(const Body& body, const TableStep& step, Binding& binding);
  Outcome Deny(const Body& body, const TableStep& step, Binding& binding);
  Computed* Compute(const TableStep& step, const Word* values, Binding& binding);
  static Binding* MakeBinding(const Contrapositive& rule, Arena& arena) {
    static_assert(sizeof(Binding) == 2 * sizeof(Word) && alignof(Binding) <= alignof(Word));
    return new (arena.Allocate(2 + std::size_t{rule.slots})) Binding{nullptr, 0};
  }
  static Binding* CopyOf(const Contrapositive& rule, Binding& binding, Arena& arena) {
    Binding* copy = MakeBinding(rule, arena);
    *copy = binding;
    Word* to = copy->slots();
    const Word* from = binding.slots();
    for (std::uint32_t i = 0; i < rule.slots; ++i) to[i] = from[i];
    return copy;
  }
  void Inherit(const Origin& origin, Binding& binding) {
    if (origin.resting != nullptr) binding.resting = Join(binding.resting, origin.resting);
    binding.depth = std::max<std::size_t>(binding.depth, origin.depth);
  }
  bool Evaluate(Run& run, Table& table);
  bool EvaluateRule(const Body& body);
  void EvaluateFacts(Table& table);
  bool EvaluateComponent(Run& run, Table& table);
  bool Resume(std::uint32_t number);
  bool TakeAnswers(std::uint32_t number, Output& output);
  bool Unfit(Run& run);
  bool HasEnded(const Run& run) const { return run.enough || run.unfit || shop_.meter->stopped(); }

  /// False when it is known already.
  bool AddAnswer(Table& table, const Word* row, const Origin& origin);
  bool IsNew(const Table& table, const Word* row);
  /// The table of the call that binds nothing; null unless it is complete.
  Table* GeneralTable(const TableStep& step) const {
    const std::size_t label = step.call->label;
    if (label >= general_.size() || general_[label] == nullptr) return nullptr;
    return general_[label]->state == State::kComplete ? general_[label] : nullptr;
  }
  Table* FindTable(const TableStep& step, const Word* values, bool& added);
  Table* MakeTable(const TableStep& step, const Word* values);
  Table* TakeTable(std::size_t arity);
  bool IsCall(const Table& table, const TableStep& step, const Word* values);
  void Subscribe(const Body& body, std::size_t step, Binding& binding, Table& table);
  void CloseTables(std::size_t first, State state);

  // Terms and numbers (table_terms.cc).
  bool Differ(const TableStep& step, const Word* slots);
  bool Compare(const TableStep& step, const Word* slots);
  bool Agrees(const TableStep& step, const Word* values, const Word* row) {
    for (const Operand& operand : step.operands) {
      if (!AreSame(*values++, row[operand.argument])) return false;
    }
    return true;
  }
  bool Match(const MatchCode& pattern, const Word* given, Word* slots) {
    if (!pattern.binds_only) return MatchParts(pattern, given, slots);
    for (const MatchStep& step : pattern.steps) slots[step.slot] = given[step.source];
    return true;
  }
  bool MatchParts(const MatchCode& pattern, const Word* given, Word* slots);
  bool AreSame(Word a, Word b) { return a == b || (TagOf(a) == TagOf(b) && AreSameWithin(a, b)); }
  bool AreSameWithin(Word a, Word b);
  /// A copy that lasts.
  Word Keep(Word word) { return copier_.Copy(word, store_.arena); }
  bool ReadNumber(const Operand& operand, const Word* slots, Number& number) {
    if (operand.kind == Operand::Kind::kCalculation) return Calculate(operand, slots, number);
    if (operand.kind == Operand::Kind::kMixed) return Mix(operand, slots, number);
    const Word word = operand.kind == Operand::Kind::kSlot ? slots[operand.slot] : operand.word;
    if (!IsNumber(word)) return false;
    number = Number::In(word);
    return true;
  }
  bool Calculate(const Operand& operand, const Word* slots, Number& number);
  bool Mix(const Operand& operand, const Word* slots, Number& number);
  bool MakeMixed(const Operand& operand, const Word* slots, Maker& maker, Word& value);
  bool MakeValue(const Operand& operand, const Word* slots, Maker& maker, Word& value) {
    if (operand.kind != Operand::Kind::kSlot) return MakeWord(operand, slots, maker, value);
    value = slots[operand.slot];
    return true;
  }
  bool MakeWord(const Operand& operand, const Word* slots, Maker& maker, Word& value);
  bool MakeValues(const TableStep& step, const Word* slots, Word* values) {
    for (const Operand& operand : step.operands) {
      if (!MakeValue(operand, slots, stack_, *values++)) return false;
    }
    return true;
  }
  /// Those of a step's ground arguments; null when one has none.
  const Word* ValuesOf(const TableStep& step, const Word* slots) {
    const auto& operands = step.operands;
    if (operands.empty()) return slots;
    if (operands.size() == 1 && operands.front().kind == Operand::Kind::kSlot) {
      return slots + operands.front().slot;
    }
    Word* values = stack_.arena.Allocate(operands.size());
    return MakeValues(step, slots, values) ? values : nullptr;
  }
  const Resting* Join(const Resting* a, const Resting* b);
  bool Count() const {
    shop_.meter->CountWork();
    return !shop_.meter->stopped();
  }

  Workshop shop_;
  Maker store_;  ///< What lasts for the decision.
  Maker stack_;  ///< What lasts for a step.
  Unifier comparer_;
  std::array<Word, kMostArguments> free_{};  ///< Unbound variables for arguments of attachments.
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
  TermCopier copier_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLES_H_

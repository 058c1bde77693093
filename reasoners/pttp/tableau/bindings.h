// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_BINDINGS_H_
#define LATCHWORK_PTTP_TABLEAU_BINDINGS_H_

#include <cstdint>

#include "reasoners/pttp/tableau/fingerprint.h"
#include "reasoners/pttp/tableau/grow_stack.h"
#include "reasoners/pttp/tableau/matrix.h"

namespace latchwork::pttp {

/// The variables of all clause copies of a tableau, by number, and between them the arguments of
/// its goals. Terms are never copied: a variable is bound to a cell of the matrix and the copy that
/// the cell belongs to (Boyer and Moore, "The sharing of structure in theorem-proving programs",
/// 1972).
class Bindings {
 public:
  explicit Bindings(const Matrix& matrix) : cells_(matrix.cells()) {}

  static constexpr std::uint64_t kMostWork = std::uint64_t{1} << 20U;
  /// Whether a comparison was ever too long to be finished, and taken for a failure.
  bool gave_up() const { return gave_up_; }

  std::uint32_t size() const { return static_cast<std::uint32_t>(values_.size()); }
  std::uint32_t trail_size() const { return static_cast<std::uint32_t>(trail_.size()); }
  std::size_t bytes() const {
    return values_.bytes() + trail_.bytes() + pairs_.bytes() + visits_.bytes();
  }

  /// One more copy of a clause: its variables, after a cell that says whether a term with any of
  /// them was ever the value of a variable that a goal or its arguments lead to.
  std::uint32_t Allocate(std::uint32_t slots) {
    const std::uint32_t base = size();
    Instance* fresh = values_.Extend(slots + 1);
    for (std::uint32_t i = 0; i < GrowStack<Instance>::kSlack; ++i) fresh[i] = {};
    for (std::uint32_t i = GrowStack<Instance>::kSlack; i <= slots; ++i) fresh[i] = {};
    return base;
  }
  /// Puts the arguments of a goal on top, as they are now.
  [[gnu::always_inline]] Fingerprint PushArguments(const MatrixLiteral& goal, std::uint32_t base) {
    Instance* arguments = values_.Extend(goal.arity);
    const Cell* cells = cells_ + goal.arguments;
    for (std::uint32_t i = 0; i < goal.given; ++i) arguments[i] = {cells[i], base};
    Fingerprint print = goal.print;
    for (const Probe* probe = goal.probes; probe != goal.probes_end; ++probe) {
      const Instance term = ResolveVariable({probe->variable, base});
      if (probe->argument != Probe::kNone) arguments[probe->argument] = term;
      if (IsVariable(term.cell) || probe->place == Fingerprint::kPlaces) continue;
      const Cell* block = BlockOfCell(cells_, term.cell);
      print.Set(probe->place, block[0]);
      if (probe->below == Fingerprint::kPlaces) continue;
      for (std::uint32_t i = 0; i < block[1] && i < Fingerprint::kBelow; ++i) {
        const Instance argument = Resolve({block[2 + i], term.base});
        if (IsVariable(argument.cell)) continue;
        print.Set(probe->below + i, *BlockOfCell(cells_, argument.cell));
      }
    }
    return print;
  }
  /// Undoes bindings down to `trail`, then forgets copies and goals from `variables` on.
  void UndoTo(std::uint32_t trail, std::uint32_t variables) {
    while (trail_.size() > trail) values_[trail_.Pop()] = {};
    values_.Truncate(variables);
  }
  /// Bindings of variables from `mark` on need not be undone one by one.
  void TrailBelow(std::uint32_t mark) { mark_ = mark; }
  /// Whether every binding since `trail` was of a variable from `mark` on.
  bool BoundOnlyFrom(std::uint32_t mark, std::uint32_t trail) const {
    for (std::uint32_t i = trail; i < trail_.size(); ++i) {
      if (trail_[i] < mark) return false;
    }
    return true;
  }

  static std::uint32_t VariableOf(Instance term) { return term.base + (term.cell >> 2U); }
  Instance Resolve(Instance term) const {
    return IsVariable(term.cell) ? ResolveVariable(term) : term;
  }

  /// Unifies a head, whose copy is at `base`, with the pushed arguments of a goal. Bindings made
  /// before a failure stay.
  bool UnifyHead(const HeadArgument* head, std::uint32_t base, std::uint32_t goal,
                 std::uint32_t count) {
    work_ = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!UnifyArgument(head[i], base, values_[goal + i])) return false;
    }
    return true;
  }
  /// The same of two goals.
  bool UnifyGoals(std::uint32_t left, std::uint32_t right, std::uint32_t count) {
    work_ = 0;
    safe_ = false;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!UnifyTerms(values_[left + i], values_[right + i])) return false;
    }
    return true;
  }
  bool Identical(std::uint32_t left, std::uint32_t right, std::uint32_t count) {
    work_ = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!SameTerms(values_[left + i], values_[right + i])) return false;
    }
    return true;
  }

 private:
  struct Pair {
    Instance left;
    Instance right;
  };

  Instance ResolveVariable(Instance term) const {
    for (;;) {
      const Instance next = values_[VariableOf(term)];
      if (next.cell == 0) return term;
      term = next;
      if (!IsVariable(term.cell)) return term;
    }
  }
  /// Notes that a variable leads to the value.
  void Reach(Instance value) { values_[value.base].cell |= ~value.cell & kGroundTag; }
  void Bind(Instance variable, Instance value) {
    const std::uint32_t number = VariableOf(variable);
    values_[number] = value;
    Reach(value);
    if (number < mark_) trail_.Push(number);
  }
  bool UnifyArgument(HeadArgument head, std::uint32_t base, Instance goal) {
    if (head.step <= HeadStep::kFirst) {
      values_[base + (head.cell >> 2U)] = goal;
      if (head.step == HeadStep::kFirst) Reach(goal);
      return true;
    }
    const Instance term{head.cell, base};
    if (head.step == HeadStep::kAny) {
      safe_ = false;
      return UnifyTerms(term, goal);
    }
    goal = Resolve(goal);
    if (IsVariable(goal.cell)) {
      Bind(goal, term);
      return true;
    }
    safe_ = true;
    return goal.cell == head.cell && IsGround(goal.cell) ? true : UnifyBlocks(term, goal);
  }
  /// Whether a variable may occur in a term: not if no term but this has variables of its copy.
  bool MayOccur(Instance variable, Instance value) const {
    return !safe_ && !IsGround(value.cell) &&
           (value.base == variable.base || values_[variable.base].cell != 0);
  }
  bool BindChecked(Instance variable, Instance value) {
    if (MayOccur(variable, value) && Occurs(VariableOf(variable), value)) return false;
    Bind(variable, value);
    return true;
  }
  bool UnifyTerms(Instance a, Instance b) {
    a = Resolve(a);
    b = Resolve(b);
    if (SamePlace(a, b)) return true;
    if (IsVariable(a.cell)) {
      if (!IsVariable(b.cell)) return BindChecked(a, b);
      const bool a_is_younger = VariableOf(a) > VariableOf(b);
      Bind(a_is_younger ? a : b, a_is_younger ? b : a);
      return true;
    }
    if (IsVariable(b.cell)) return BindChecked(b, a);
    return UnifyBlocks(a, b);
  }
  bool SameTerms(Instance a, Instance b) {
    if (SamePlace(a, b)) return true;
    a = Resolve(a);
    b = Resolve(b);
    if (SamePlace(a, b)) return true;
    return !IsVariable(a.cell) && !IsVariable(b.cell) && !DifferAtOnce(a, b) && SameBelow(a, b);
  }
  static bool SamePlace(Instance a, Instance b) {
    return a.cell == b.cell && (a.base == b.base || IsGround(a.cell));
  }
  /// Of two terms in different places that are no variables.
  bool DifferAtOnce(Instance a, Instance b) const {
    return IsGround(a.cell & b.cell) ||
           *BlockOfCell(cells_, a.cell) != *BlockOfCell(cells_, b.cell);
  }
  bool UnifyBlocks(Instance a, Instance b) { return !DifferAtOnce(a, b) && UnifyBelow(a, b); }
  /// Whether one comparison may go on. Terms that share their parts can be exponentially larger
  /// than what they are written with.
  bool Spend(std::uint32_t steps) {
    work_ += steps;
    gave_up_ = gave_up_ || work_ > kMostWork;
    return work_ <= kMostWork;
  }
  template <typename Agree>
  bool AgreeBelow(Instance a, Instance b, const Agree& agree);
  bool UnifyBelow(Instance a, Instance b);
  bool SameBelow(Instance a, Instance b);
  bool Occurs(std::uint32_t variable, Instance term);

  const Cell* cells_;
  GrowStack<Instance> values_;
  GrowStack<std::uint32_t> trail_;
  std::uint32_t mark_ = 0;
  bool safe_ = false;
  bool gave_up_ = false;
  std::uint64_t work_ = 0;
  GrowStack<Pair> pairs_;
  GrowStack<Instance> visits_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_BINDINGS_H_

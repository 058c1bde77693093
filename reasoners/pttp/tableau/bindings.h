// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_BINDINGS_H_
#define LATCHWORK_PTTP_TABLEAU_BINDINGS_H_

#include <algorithm>
#include <array>
#include <cstdint>

#include "reasoners/pttp/tableau/fingerprint.h"
#include "reasoners/pttp/tableau/grow_stack.h"
#include "reasoners/pttp/tableau/matrix.h"

namespace latchwork::pttp {

/// The terms of a tableau in one stack: the matrix, the variables of each clause copy, the
/// arguments of goals and what unification made, as in Warren's abstract machine (1983). A variable
/// is a cell that is 0 as long as it has no value; terms without variables are marked when they are
/// made.
class Bindings {
 public:
  explicit Bindings(const Matrix& matrix);

  static constexpr std::uint64_t kMostWork = std::uint64_t{1} << 20U;
  /// How deep the operations of a head go.
  static constexpr std::uint32_t kMostNested = 24;
  /// Whether a comparison was ever too long to be finished, and taken for a failure.
  bool gave_up() const { return gave_up_; }

  std::uint32_t size() const { return static_cast<std::uint32_t>(cells_.size()); }
  std::uint32_t trail_size() const { return static_cast<std::uint32_t>(trail_.size()); }
  std::size_t bytes() const {
    return cells_.bytes() + trail_.bytes() + pairs_.bytes() + visits_.bytes();
  }
  /// Whether the next clause copies may be more than can be addressed.
  bool full() const { return cells_.size() > kMostCells; }

  /// The variables of one more copy of a clause, and room for what its head makes.
  std::uint32_t Allocate(const Entry& entry) {
    const std::uint32_t base = size() - 1;
    cells_.Reserve(entry.slots + entry.words);
    Cell* fresh = cells_.Extend(entry.slots);
    for (std::uint32_t i = 0; i < GrowStack<Cell>::kSlack; ++i) fresh[i] = 0;
    for (std::uint32_t i = GrowStack<Cell>::kSlack; i < entry.slots; ++i) fresh[i] = 0;
    return base;
  }
  struct Arguments {
    Fingerprint print;
    std::uint32_t first = 0;  ///< Where they are.
    std::uint32_t hash = 0;   ///< 0: they may have variables, or all are of the matrix.
  };
  /// Puts the arguments of a goal on top, as they are now.
  [[gnu::always_inline]] Arguments PushArguments(const MatrixLiteral& goal, std::uint32_t base) {
    cells_.Reserve(goal.words);
    if (goal.code.first != goal.code.end) Make(goal.code, base);
    Arguments made;
    made.first = size();
    Cell* arguments = cells_.Extend(goal.arity);
    const Cell* cells = cells_.data() + goal.arguments;
    Cell ground = kGroundTag;
    Cell compound = 0;
    for (std::uint32_t i = 0; i < goal.arity; ++i) {
      const Cell argument = MakeArgument(cells[i], base, arguments + i);
      ground &= argument;
      compound |= argument;
    }
    if (ground != 0 && TagOfCell(compound) == kBuiltTag) {
      made.hash = HashOf(goal.key, arguments, goal.arity) | 1U;
    }
    made.print = goal.print;
    LookUpProbes(goal, base, arguments, made.print);
    return made;
  }
  /// Undoes bindings down to `trail`, then forgets copies and goals from `size` on.
  void UndoTo(std::uint32_t trail, std::uint32_t size) {
    while (trail_.size() > trail) cells_[trail_.Pop()] = 0;
    cells_.Truncate(size);
  }
  void Clear() { UndoTo(0, first_); }
  /// Bindings of variables from `mark` on need not be undone one by one.
  void TrailBelow(std::uint32_t mark) { mark_ = mark; }
  /// Whether every binding since `trail` was of a variable from `mark` on.
  bool BoundOnlyFrom(std::uint32_t mark, std::uint32_t trail) const {
    for (std::uint32_t i = trail; i < trail_.size(); ++i) {
      if (trail_[i] < mark) return false;
    }
    return true;
  }

  /// The term at a cell of an argument list.
  Cell ArgumentAt(std::uint32_t at) const {
    const Cell cell = cells_[at];
    if (!IsVariable(cell)) return cell;
    return cell == 0 ? VariableAt(at) : ResolveVariable(cell);
  }
  const Cell* Block(Cell cell) const { return BlockOfCell(cells_.data(), cell); }

  /// Unifies a head, whose copy is at `base`, with the pushed arguments of a goal. Bindings made
  /// before a failure stay.
  bool UnifyHead(const HeadOperation* operation, std::uint32_t base, const MatrixLiteral& goal,
                 std::uint32_t arguments) {
    Begin(goal, arguments);
    return RunHead(operation, base, arguments);
  }
  /// The same of two goals, the second one newer.
  bool UnifyGoals(std::uint32_t left, const MatrixLiteral& goal, std::uint32_t right) {
    Begin(goal, right);
    for (std::uint32_t i = 0; i < goal.arity; ++i) {
      if (!Unify(ArgumentAt(left + i), ArgumentAt(right + i))) return false;
    }
    return true;
  }
  bool Identical(std::uint32_t left, std::uint32_t right, std::uint32_t count) {
    work_ = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!Same(left + i, right + i)) return false;
    }
    return true;
  }

 private:
  struct Pair {
    Cell left;
    Cell right;
  };
  static constexpr std::size_t kMostCells = std::size_t{1} << 29U;

  /// Of the terms at two cells of argument lists.
  bool Same(std::uint32_t left, std::uint32_t right) {
    if (cells_[left] == cells_[right] && cells_[left] != 0) return true;
    const Cell a = ArgumentAt(left);
    const Cell b = ArgumentAt(right);
    if (a == b) return true;
    return !IsVariable(a) && !IsVariable(b) && !Differ(a, b) && SameBelow(a, b);
  }

  static Cell VariableAt(std::uint32_t at) { return at << 2U; }
  static std::uint32_t PlaceOf(Cell variable) { return variable >> 2U; }
  Cell ResolveVariable(Cell variable) const {
    for (;;) {
      const Cell value = cells_[PlaceOf(variable)];
      if (value == 0) return variable;
      if (!IsVariable(value)) return value;
      variable = value;
    }
  }

  /// Writes a term; `cell` is of the matrix, kOpenTag stands for what was written there before.
  Cell MakeArgument(Cell cell, std::uint32_t base, Cell* out) {
    switch (TagOfCell(cell)) {
      case kGroundTag:
        return *out = cell;
      case kVariableTag:
        return MakeVariable(base + (cell >> 2U), out);
      default:
        return *out;
    }
  }
  Cell MakeVariable(std::uint32_t slot, Cell* out) {
    const Cell value = cells_[slot];
    if (!IsVariable(value)) return *out = value;
    if (value != 0) return *out = ResolveVariable(value);
    const auto place = static_cast<std::uint32_t>(out - cells_.data());
    cells_[slot] = VariableAt(place);
    if (slot < mark_) trail_.Push(slot);
    return *out = 0;
  }
  std::uint32_t HashOf(std::uint32_t hash, const Cell* arguments, std::uint32_t count) const {
    for (std::uint32_t i = 0; i < count; ++i) {
      hash = AddToHash(hash, HashOfGround(cells_.data(), arguments[i]));
    }
    return hash;
  }
  /// Writes a term that there is room for.
  Cell Make(TermCode made_by, std::uint32_t base);
  void LookUpProbes(const MatrixLiteral& goal, std::uint32_t base, const Cell* arguments,
                    Fingerprint& print) const {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): a place is looked up after that above
    std::array<Cell, Fingerprint::kPlaces> terms;
    for (const Probe* probe = goal.probes; probe != goal.probes_end; ++probe) {
      const Cell term = LookUp(*probe, base, arguments, terms.data());
      terms[probe->place] = term;
      if (!IsVariable(term)) print.Set(probe->place, *Block(term));
    }
  }
  Cell LookUp(const Probe& probe, std::uint32_t base, const Cell* arguments,
              const Cell* terms) const {
    if (probe.argument != Probe::kNone) return arguments[probe.argument];
    if (probe.above == Probe::kNowhere) return ArgumentAt(base + probe.variable);
    const Cell around = terms[probe.above];
    if (IsVariable(around) || Block(around)[1] <= probe.index) return 0;
    return ArgumentAt((around >> 2U) + 2 + probe.index);
  }

  bool RunHead(const HeadOperation* operation, std::uint32_t base, std::uint32_t at);
  /// Before a goal is unified. Cells from `goal_` on are its own.
  void Begin(const MatrixLiteral& goal, std::uint32_t arguments) {
    work_ = 0;
    goal_ = arguments + goal.arity - goal.words;
    outside_bound_ = false;
  }
  void Bind(Cell variable, Cell value) {
    const std::uint32_t place = PlaceOf(variable);
    cells_[place] = value;
    outside_bound_ = outside_bound_ || place < goal_;
    if (place < mark_) trail_.Push(place);
  }
  bool BindChecked(Cell variable, Cell value) {
    if (!IsGround(value) && Occurs(variable, value)) return false;
    Bind(variable, value);
    return true;
  }
  bool Unify(Cell a, Cell b) {
    if (a == b) return true;
    if (IsVariable(a)) {
      if (!IsVariable(b)) return BindChecked(a, b);
      Bind(std::max(a, b), std::min(a, b));
      return true;
    }
    if (IsVariable(b)) return BindChecked(b, a);
    return !Differ(a, b) && UnifyBelow(a, b);
  }
  /// Whether two terms in different places that are no variables differ as far as can be seen.
  bool Differ(Cell a, Cell b) const {
    const Cell* x = Block(a);
    const Cell* y = Block(b);
    return *x != *y || (IsGround(a & b) && x[-1] != y[-1]);
  }
  /// Whether one comparison may go on. Terms that share their parts can be exponentially larger
  /// than what they are written with.
  bool Spend(std::uint32_t steps) {
    work_ += steps;
    gave_up_ = gave_up_ || work_ > kMostWork;
    return work_ <= kMostWork;
  }
  template <typename Agree>
  bool AgreeBelow(Cell a, Cell b, const Agree& agree);
  bool UnifyBelow(Cell a, Cell b);
  bool SameBelow(Cell a, Cell b);
  bool Occurs(Cell variable, Cell term);
  bool MeetOpen(const HeadOperation& operation, std::uint32_t base, Cell variable);
  bool UnifyGround(Cell ground, Cell term) {
    if (ground == term) return true;
    if (!IsVariable(term)) return TagOfCell(term) != kGroundTag && Unify(ground, term);
    Bind(term, ground);
    return true;
  }

  const Cell* codes_;
  std::uint32_t first_ = 0;  ///< Where the matrix ends.
  GrowStack<Cell> cells_;
  GrowStack<std::uint32_t> trail_;
  std::uint32_t mark_ = 0;
  std::uint32_t goal_ = 0;
  bool outside_bound_ = false;
  bool gave_up_ = false;
  std::uint64_t work_ = 0;
  GrowStack<Pair> pairs_;
  GrowStack<Cell> visits_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_BINDINGS_H_

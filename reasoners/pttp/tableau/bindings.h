// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_BINDINGS_H_
#define LATCHWORK_PTTP_TABLEAU_BINDINGS_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "reasoners/pttp/tableau/grow_stack.h"
#include "reasoners/pttp/tableau/matrix.h"

namespace latchwork::pttp {

/// An instance of a term of the matrix: its cell and where its clause's variables begin.
struct Instance {
  Cell cell = 0;
  std::uint32_t base = 0;
};

/// The variables of all clause copies of a tableau, by number. Terms are never copied: a variable
/// is bound to a cell of the matrix and the copy that the cell belongs to (Boyer and Moore, "The
/// sharing of structure in theorem-proving programs", 1972).
class Bindings {
 public:
  explicit Bindings(const Matrix& matrix) : cells_(matrix.cells()) {}

  static constexpr std::uint64_t kMostWork = std::uint64_t{1} << 20U;
  /// Whether a comparison was ever too long to be finished, and taken for a failure.
  bool gave_up() const { return gave_up_; }

  std::uint32_t size() const { return static_cast<std::uint32_t>(values_.size()); }
  std::uint32_t trail_size() const { return static_cast<std::uint32_t>(trail_.size()); }
  std::size_t bytes() const { return values_.bytes() + trail_.bytes(); }

  /// The variables of one more copy of a clause.
  std::uint32_t Allocate(std::uint32_t slots) {
    const std::uint32_t base = size();
    Instance* fresh = values_.Extend(slots);
    for (std::uint32_t i = 0; i < slots; ++i) fresh[i] = {};
    return base;
  }
  /// Undoes bindings down to `trail`, then forgets copies from `variables` on.
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

  Instance Resolve(Instance term) const {
    while (TagOfCell(term.cell) == kVariableTag) {
      const Instance next = values_[term.base + SlotOfCell(term.cell)];
      if (next.cell == 0) return term;
      term = next;
    }
    return term;
  }
  /// What a term demands of one that it is to be unified with: its functor; 0: nothing.
  std::uint32_t KeyOf(Instance term) const {
    term = Resolve(term);
    switch (TagOfCell(term.cell)) {
      case kVariableTag:
        return 0;
      case kConstantTag:
        return OffsetOfCell(term.cell);
      default:
        return cells_[OffsetOfCell(term.cell)];
    }
  }

  /// Unifies two lists of arguments. Bindings made before a failure stay. `safe`: no variable can
  /// become part of its own value.
  bool Unify(const Cell* left, std::uint32_t left_base, const Cell* right, std::uint32_t right_base,
             std::uint32_t count, bool safe) {
    safe_ = safe;
    work_ = 0;
    old_leads_on_ = fresh_leads_on_ = false;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!UnifyTerms({left[i], left_base}, {right[i], right_base})) return false;
    }
    return true;
  }
  bool Identical(const Cell* left, std::uint32_t left_base, const Cell* right,
                 std::uint32_t right_base, std::uint32_t count) {
    work_ = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!SameTerms({left[i], left_base}, {right[i], right_base})) return false;
    }
    return true;
  }

 private:
  static std::uint32_t VariableOf(Instance term) { return term.base + SlotOfCell(term.cell); }

  void Bind(std::uint32_t variable, Instance value) {
    const bool leads_on =
        TagOfCell(value.cell) == kOpenTag || TagOfCell(value.cell) == kVariableTag;
    values_[variable] = value;
    if (variable < mark_) {
      trail_.Push(variable);
      old_leads_on_ = old_leads_on_ || leads_on;
    } else {
      fresh_leads_on_ = fresh_leads_on_ || leads_on;
    }
  }
  /// Whether a variable may occur in a term: between the goal's variables and those of the new
  /// copy there is no way until one of the other side has been bound to something with variables.
  bool MayOccur(std::uint32_t variable, Instance value) const {
    if (safe_ || TagOfCell(value.cell) != kOpenTag) return false;
    if (variable >= mark_) return value.base >= mark_ || old_leads_on_;
    return value.base < mark_ || fresh_leads_on_;
  }
  bool BindChecked(std::uint32_t variable, Instance value) {
    if (MayOccur(variable, value) && Occurs(variable, value)) return false;
    Bind(variable, value);
    return true;
  }
  bool UnifyTerms(Instance a, Instance b) {
    a = Resolve(a);
    b = Resolve(b);
    if (TagOfCell(a.cell) == kVariableTag) {
      if (TagOfCell(b.cell) != kVariableTag) return BindChecked(VariableOf(a), b);
      const std::uint32_t x = VariableOf(a);
      const std::uint32_t y = VariableOf(b);
      if (x > y) {
        Bind(x, b);
      } else if (x < y) {
        Bind(y, a);
      }
      return true;
    }
    if (TagOfCell(b.cell) == kVariableTag) return BindChecked(VariableOf(b), a);
    if (a.cell == b.cell && (TagOfCell(a.cell) != kOpenTag || a.base == b.base)) return true;
    if (TagOfCell(a.cell) == kConstantTag || TagOfCell(b.cell) == kConstantTag) return false;
    if (TagOfCell(a.cell) == kGroundTag && TagOfCell(b.cell) == kGroundTag) return false;
    return UnifyCompounds(a, b);
  }
  bool SameTerms(Instance a, Instance b) {
    a = Resolve(a);
    b = Resolve(b);
    if (a.cell == b.cell && (a.base == b.base || TagOfCell(a.cell) == kConstantTag ||
                             TagOfCell(a.cell) == kGroundTag)) {
      return true;
    }
    if (TagOfCell(a.cell) == kVariableTag || TagOfCell(b.cell) == kVariableTag) {
      return TagOfCell(a.cell) == TagOfCell(b.cell) && VariableOf(a) == VariableOf(b);
    }
    if (TagOfCell(a.cell) == kConstantTag || TagOfCell(b.cell) == kConstantTag) return false;
    if (TagOfCell(a.cell) == kGroundTag && TagOfCell(b.cell) == kGroundTag) return false;
    return SameCompounds(a, b);
  }
  /// Whether one comparison may go on. Terms that share their parts can be exponentially larger
  /// than what they are written with.
  bool Spend(std::uint32_t steps) {
    work_ += steps;
    gave_up_ = gave_up_ || work_ > kMostWork;
    return work_ <= kMostWork;
  }
  template <typename Agree>
  bool AgreeBelow(Instance a, Instance b, const Agree& agree);
  bool UnifyCompounds(Instance a, Instance b);
  bool SameCompounds(Instance a, Instance b);
  bool Occurs(std::uint32_t variable, Instance term);

  const Cell* cells_;
  GrowStack<Instance> values_;
  GrowStack<std::uint32_t> trail_;
  std::uint32_t mark_ = 0;
  bool safe_ = false;
  bool gave_up_ = false;
  std::uint64_t work_ = 0;
  bool old_leads_on_ = false;    ///< A variable below the mark was bound to variables.
  bool fresh_leads_on_ = false;  ///< A variable from the mark on was.
  std::vector<std::pair<Instance, Instance>> pairs_;
  std::vector<Instance> visits_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_BINDINGS_H_

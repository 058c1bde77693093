// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_SUBSTITUTION_H_
#define LATCHWORK_PTTP_SATURATION_SUBSTITUTION_H_

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "reasoners/pttp/saturation/rebuilder.h"
#include "reasoners/pttp/saturation/terms.h"

namespace latchwork::pttp::saturation {

/// The most general unifier of terms of two clauses whose variables are kept apart by a bank
/// number, 0 or 1, instead of being renamed.
class Substitution {
 public:
  explicit Substitution(Terms& terms) : terms_(terms), rebuilder_(terms) {}

  void Reset();
  /// Extends the substitution; after a failure it must be reset.
  bool Unify(Item first, Item second);
  /// The instance, its unbound variables numbered in order of first appearance since Reset.
  TermId Apply(Item item) { return ApplyReplacing(item, {}, kNoTerm); }
  /// The instance with every occurrence of `from` replaced by `to`, which is an instance already.
  TermId ApplyReplacing(Item root, Item from, TermId to);
  /// Something was given up because of its size since the object was made.
  bool overflowed() const { return overflowed_; }

 private:
  Item Resolve(Item item) const;
  bool Occurs(Item variable, Item in);
  void Bind(Item variable, Item value);
  Item& Slot(Item variable);
  TermId Rename(Item variable);

  Terms& terms_;
  Rebuilder rebuilder_;
  std::vector<Item> bindings_;  ///< By twice the variable's number plus bank.
  std::vector<std::size_t> trail_;
  std::vector<TermId> names_;  ///< New variables, indexed as bindings_.
  std::vector<std::size_t> named_;
  std::vector<std::pair<Item, Item>> pairs_;
  std::vector<Item> visits_;
  bool overflowed_ = false;
};

/// One-way matching: the variables of patterns are bound, those of targets are constants.
class Matcher {
 public:
  explicit Matcher(Terms& terms) : terms_(terms), rebuilder_(terms) {}

  /// Extends the bindings; after a failure go back with Undo.
  bool Match(TermId pattern, TermId target);
  std::size_t Mark() const { return trail_.size(); }
  void Undo(std::size_t mark);
  void Bind(std::uint32_t variable, TermId value);
  /// The instance of a pattern; variables that are not bound stay. kNoTerm when it is enormous.
  TermId Apply(TermId pattern);
  /// Whether the bindings map variables to variables, one to one.
  bool IsRenaming() const;

 private:
  Terms& terms_;
  Rebuilder rebuilder_;
  std::vector<TermId> bindings_;
  std::vector<std::uint32_t> trail_;
  std::vector<std::pair<TermId, TermId>> pairs_;
};

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_SUBSTITUTION_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_UNIFIER_H_
#define LATCHWORK_PTTP_UNIFIER_H_

#include <cstddef>
#include <utility>
#include <vector>

#include "reasoners/pttp/terms/arena.h"
#include "reasoners/pttp/terms/word.h"

namespace latchwork::pttp {

/// Bindings, the trail that undoes them, and sound unification (with occurs check). Works with
/// explicit stacks, so the depth of terms does not matter. One unification that needs more than
/// kWorkLimit steps fails and sets `exhausted`.
class Unifier {
 public:
  explicit Unifier(Arena& heap) : heap_(&heap) {}

  static constexpr std::size_t kWorkLimit = std::size_t{1} << 20U;

  std::size_t trail_size() const { return trail_.size(); }
  void UndoTo(std::size_t size) {
    while (trail_.size() > size) {
      Word* cell = trail_.back();
      trail_.pop_back();
      *cell = Reference(cell);
    }
  }

  /// For a new search after one that an exception ended.
  void ForgetTrail() { trail_.clear(); }

  /// Unifies two terms. Bindings made before a failure stay on the trail.
  bool Unify(Word a, Word b);
  /// Unifies the arguments of a clause head with those of a goal; `slots` are the clause's
  /// variables. A linear head (no variable twice) needs no occurs check.
  bool UnifyHead(const Word* head, const Word* goal, std::size_t arity, Word* slots, bool linear);
  /// Copies a template, its slots replaced by the variables.
  Word Build(Word word, const Word* slots);
  /// Fresh variables.
  Word* MakeSlots(std::size_t count);

  /// Equal as they are bound now.
  bool Identical(Word a, Word b);
  /// `word` may be a template when `slots` is given.
  bool IsGround(Word word, const Word* slots = nullptr);

  bool exhausted() const { return exhausted_; }
  void ClearExhausted() { exhausted_ = false; }

 private:
  void Bind(Word* cell, Word value) {
    *cell = value;
    trail_.push_back(cell);
  }
  bool BindChecked(Word variable, Word value);
  bool Occurs(const Word* cell, Word word);
  bool UnifyPending();
  bool Spend() {
    if (++work_ <= kWorkLimit) return true;
    exhausted_ = true;
    return false;
  }

  Arena* heap_;
  std::vector<Word*> trail_;
  std::vector<std::pair<Word, Word>> pairs_;
  std::vector<std::pair<Word, Word>> head_pairs_;
  std::vector<Word> visits_;
  struct Copy {
    Word* place;
    const Word* block;
  };
  std::vector<Copy> copies_;
  std::size_t work_ = 0;
  bool exhausted_ = false;
};

/// Equal atomic words; false for anything else.
inline bool SameAtomic(Word a, Word b) {
  if (a == b) return true;
  return TagOf(a) == TagOf(b) && IsNumber(a) && *AddressOf(a) == *AddressOf(b);
}

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_UNIFIER_H_

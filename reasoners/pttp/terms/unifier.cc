// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/terms/unifier.h"

namespace latchwork::pttp {

bool Unifier::Occurs(const Word* cell, Word word) {
  visits_.clear();
  visits_.push_back(word);
  const Word self = Reference(cell);
  while (!visits_.empty()) {
    const Word current = Dereference(visits_.back());
    visits_.pop_back();
    if (current == self || !Spend()) return true;
    if (TagOf(current) != Tag::kCompound) continue;
    const Word* block = AddressOf(current);
    for (std::size_t i = ArityOf(block[0]); i > 0; --i) visits_.push_back(block[i]);
  }
  return false;
}

bool Unifier::BindChecked(Word variable, Word value) {
  if (variable == value) return true;
  if (TagOf(value) == Tag::kCompound && Occurs(AddressOf(variable), value)) return false;
  Bind(AddressOf(variable), value);
  return true;
}

bool Unifier::Unify(Word a, Word b) {
  work_ = 0;
  pairs_.clear();
  pairs_.emplace_back(a, b);
  return UnifyPending();
}

bool Unifier::UnifyPending() {
  while (!pairs_.empty()) {
    const Word a = Dereference(pairs_.back().first);
    const Word b = Dereference(pairs_.back().second);
    pairs_.pop_back();
    if (!Spend()) return false;
    if (TagOf(a) == Tag::kReference) {
      if (!BindChecked(a, b)) return false;
    } else if (TagOf(b) == Tag::kReference) {
      if (!BindChecked(b, a)) return false;
    } else if (TagOf(a) == Tag::kCompound && TagOf(b) == Tag::kCompound) {
      if (a == b) continue;
      const Word* left = AddressOf(a);
      const Word* right = AddressOf(b);
      if (left[0] != right[0]) return false;
      for (std::size_t i = ArityOf(left[0]); i > 0; --i) pairs_.emplace_back(left[i], right[i]);
    } else if (!SameAtomic(a, b)) {
      return false;
    }
  }
  return true;
}

bool Unifier::UnifyHead(const Word* head, const Word* goal, std::size_t arity, Word* slots,
                        bool linear) {
  work_ = 0;
  head_pairs_.clear();
  for (std::size_t i = arity; i > 0; --i) head_pairs_.emplace_back(head[i - 1], goal[i - 1]);
  while (!head_pairs_.empty()) {
    const Word pattern = head_pairs_.back().first;
    const Word term = Dereference(head_pairs_.back().second);
    head_pairs_.pop_back();
    if (!Spend()) return false;
    if (TagOf(pattern) == Tag::kSlot) {
      Word* slot = slots + NumberOf(pattern);
      if (*slot == Reference(slot)) {
        // The slots go when this step is undone, so the binding needs no trail. It can close no
        // cycle: only a slot met before can occur in the goal's terms, and then they would be
        // equal.
        if (linear || term == Reference(slot)) {
          *slot = term;
        } else if (!BindChecked(Reference(slot), term)) {
          return false;
        }
      } else {
        pairs_.clear();
        pairs_.emplace_back(*slot, term);
        if (!UnifyPending()) return false;
      }
    } else if (TagOf(term) == Tag::kReference) {
      const Word built = Build(pattern, slots);
      if (linear) {
        Bind(AddressOf(term), built);
      } else if (!BindChecked(term, Dereference(built))) {
        return false;
      }
    } else if (TagOf(pattern) == Tag::kTemplate) {
      const Word* left = AddressOf(pattern);
      if (TagOf(term) != Tag::kCompound || *AddressOf(term) != left[0]) return false;
      const Word* right = AddressOf(term);
      for (std::size_t i = ArityOf(left[0]); i > 0; --i) {
        head_pairs_.emplace_back(left[i], right[i]);
      }
    } else if (TagOf(pattern) == Tag::kCompound) {
      pairs_.clear();
      pairs_.emplace_back(pattern, term);
      if (!UnifyPending()) return false;
    } else if (!SameAtomic(pattern, term)) {
      return false;
    }
  }
  return true;
}

Word* Unifier::MakeSlots(std::size_t count) {
  Word* slots = heap_->Allocate(count);
  for (std::size_t i = 0; i < count; ++i) slots[i] = Reference(slots + i);
  return slots;
}

Word Unifier::Build(Word word, const Word* slots) {
  if (TagOf(word) == Tag::kSlot) return Dereference(Reference(slots + NumberOf(word)));
  if (TagOf(word) != Tag::kTemplate) return word;
  Word result = 0;
  copies_.clear();
  copies_.push_back({&result, AddressOf(word)});
  while (!copies_.empty()) {
    const Copy copy = copies_.back();
    copies_.pop_back();
    const std::size_t arity = ArityOf(copy.block[0]);
    Word* block = heap_->Allocate(arity + 1);
    *copy.place = Tagged(Tag::kCompound, block);
    block[0] = copy.block[0];
    for (std::size_t i = 1; i <= arity; ++i) {
      const Word argument = copy.block[i];
      if (TagOf(argument) == Tag::kTemplate) {
        copies_.push_back({block + i, AddressOf(argument)});
      } else {
        block[i] = TagOf(argument) == Tag::kSlot
                       ? Dereference(Reference(slots + NumberOf(argument)))
                       : argument;
      }
    }
  }
  return result;
}

bool Unifier::Identical(Word a, Word b) {
  pairs_.clear();
  pairs_.emplace_back(a, b);
  work_ = 0;
  while (!pairs_.empty()) {
    const Word left = Dereference(pairs_.back().first);
    const Word right = Dereference(pairs_.back().second);
    pairs_.pop_back();
    if (SameAtomic(left, right)) continue;
    if (TagOf(left) != Tag::kCompound || TagOf(right) != Tag::kCompound || !Spend()) return false;
    const Word* first = AddressOf(left);
    const Word* second = AddressOf(right);
    if (first[0] != second[0]) return false;
    for (std::size_t i = ArityOf(first[0]); i > 0; --i) pairs_.emplace_back(first[i], second[i]);
  }
  return true;
}

bool Unifier::IsGround(Word word, const Word* slots) {
  visits_.clear();
  visits_.push_back(word);
  work_ = 0;
  while (!visits_.empty()) {
    Word current = visits_.back();
    visits_.pop_back();
    if (TagOf(current) == Tag::kSlot) current = slots[NumberOf(current)];
    current = Dereference(current);
    if (TagOf(current) == Tag::kReference || !Spend()) return false;
    if (TagOf(current) != Tag::kCompound && TagOf(current) != Tag::kTemplate) continue;
    const Word* block = AddressOf(current);
    for (std::size_t i = ArityOf(block[0]); i > 0; --i) visits_.push_back(block[i]);
  }
  return true;
}

}  // namespace latchwork::pttp

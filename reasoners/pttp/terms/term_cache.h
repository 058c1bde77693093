// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TERM_CACHE_H_
#define LATCHWORK_PTTP_TERM_CACHE_H_

#include <algorithm>
#include <vector>

#include "latchwork/logic/term.h"
#include "reasoners/pttp/terms/arena.h"
#include "reasoners/pttp/terms/functors.h"
#include "reasoners/pttp/terms/row_set.h"
#include "reasoners/pttp/terms/unifier.h"

namespace latchwork::pttp {

/// Ground compound terms that were read out of the engine, kept from cycle to cycle: the objects of
/// a robot's world are the same ones again and again, and making them anew would cost memory each
/// time.
class TermCache {
 public:
  explicit TermCache(Functors& functors) : functors_(&functors), comparer_(kept_) {}

  /// Variables left are numbered in the order of `variables`, which grows.
  logic::Term Export(Word word, std::vector<Word>& variables) {
    word = Dereference(word);
    if (TagOf(word) != Tag::kCompound || !IsGround(word)) {
      return functors_->Export(word, variables);
    }
    if (terms_.size() >= kMostTerms) Clear();
    const auto fresh = static_cast<std::uint32_t>(terms_.size());
    const std::uint32_t number = known_.Enter(ShallowHash(word), fresh, [&](std::uint32_t known) {
      return AreSame(words_[known], word);
    });
    if (number == fresh) {
      terms_.push_back(functors_->Export(word, variables));
      words_.push_back(functors_->Import(terms_.back(), kept_));
    }
    return terms_[number];
  }

 private:
  static constexpr std::size_t kMostTerms = 4096;

  static bool IsAtomic(Word word) {
    return TagOf(word) != Tag::kReference && TagOf(word) != Tag::kCompound;
  }
  bool IsGround(Word word) {
    const Word* block = AddressOf(word);
    return std::all_of(block + 1, block + 1 + ArityOf(block[0]), IsAtomic) ||
           comparer_.IsGround(word);
  }
  /// For ground compound terms.
  bool AreSame(Word a, Word b) {
    const Word* block = AddressOf(a);
    const Word* other = AddressOf(b);
    if (block[0] != other[0]) return false;
    const std::size_t arity = ArityOf(block[0]);
    return std::equal(block + 1, block + 1 + arity, other + 1, SameAtomic) ||
           comparer_.Identical(a, b);
  }
  void Clear() {
    known_.Clear();
    words_.clear();
    terms_.clear();
    kept_.Clear();
  }

  Functors* functors_;
  Arena kept_;
  Unifier comparer_;
  RowSet known_;
  std::vector<Word> words_;
  std::vector<logic::Term> terms_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TERM_CACHE_H_

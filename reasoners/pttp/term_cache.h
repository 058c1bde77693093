// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TERM_CACHE_H_
#define LATCHWORK_PTTP_TERM_CACHE_H_

#include <span>
#include <vector>

#include "latchwork/logic/term.h"
#include "reasoners/pttp/functors.h"
#include "reasoners/pttp/variant_table.h"

namespace latchwork::pttp {

/// Ground compound terms that were read out of the engine, kept from cycle to cycle: the objects of
/// a robot's world are the same ones again and again, and making them anew would cost memory each
/// time.
class TermCache {
 public:
  explicit TermCache(const Functors& functors) : functors_(&functors) {}

  /// Variables left are numbered in the order of `variables`, which grows.
  logic::Term Export(Word word, std::vector<Word>& variables) {
    word = Dereference(word);
    if (TagOf(word) != Tag::kCompound) return functors_->Export(word, variables);
    if (terms_.size() >= kMostTerms) Clear();
    const auto found = keys_.Enter(0, std::span<const Word>(&word, 1));
    if (found.entry == kNoEntry) return functors_->Export(word, variables);
    if (found.added) {
      terms_.push_back(found.ground ? functors_->Export(word, variables) : logic::Term());
    }
    return found.ground ? terms_[found.entry] : functors_->Export(word, variables);
  }

 private:
  static constexpr std::size_t kMostTerms = 4096;

  void Clear() {
    keys_.Clear();
    terms_.clear();
  }

  const Functors* functors_;
  VariantTable keys_;
  std::vector<logic::Term> terms_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TERM_CACHE_H_

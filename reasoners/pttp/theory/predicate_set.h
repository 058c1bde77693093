// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PREDICATE_SET_H_
#define LATCHWORK_PTTP_PREDICATE_SET_H_

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "reasoners/pttp/theory/predicates.h"

namespace latchwork::pttp {

/// A set of predicates. Keeps its memory when cleared.
class PredicateSet {
 public:
  void Clear() { words_.clear(); }
  void Add(PredicateId predicate) {
    if (predicate / 64 >= words_.size()) words_.resize(predicate / 64 + 1, 0);
    words_[predicate / 64] |= std::uint64_t{1} << (predicate % 64);
  }
  void AddAll(const PredicateSet& other) {
    if (other.words_.size() > words_.size()) words_.resize(other.words_.size(), 0);
    for (std::size_t i = 0; i < other.words_.size(); ++i) words_[i] |= other.words_[i];
  }
  template <typename Test>
  bool Any(Test&& test) const {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      for (std::uint64_t bits = words_[i]; bits != 0; bits &= bits - 1) {
        const auto bit = static_cast<std::size_t>(std::countr_zero(bits));
        if (test(static_cast<PredicateId>(64 * i + bit))) return true;
      }
    }
    return false;
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PREDICATE_SET_H_

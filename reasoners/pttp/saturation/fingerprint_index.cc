// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/fingerprint_index.h"

#include <algorithm>

namespace latchwork::pttp::saturation {
namespace {

/// What can stand at a position besides a function symbol.
constexpr std::int32_t kAbsent = -1;
constexpr std::int32_t kVariable = -2;
constexpr std::int32_t kBelowVariable = -3;

}  // namespace

std::int32_t FingerprintIndex::Argument(TermId term, std::int32_t part, std::size_t index,
                                        TermId& argument) const {
  argument = kNoTerm;
  if (part == kVariable || part == kBelowVariable) return kBelowVariable;
  if (part == kAbsent) return kAbsent;
  const auto arguments = terms_.arguments(term);
  if (index >= arguments.size()) return kAbsent;
  argument = arguments[index];
  if (Terms::IsVariable(argument)) return kVariable;
  return static_cast<std::int32_t>(terms_.head(argument));
}

FingerprintIndex::Trie::Key FingerprintIndex::Fingerprint(TermId term) const {
  Trie::Key key{};
  key[0] = Terms::IsVariable(term) ? kVariable : static_cast<std::int32_t>(terms_.head(term));
  TermId first = kNoTerm;
  TermId second = kNoTerm;
  TermId other = kNoTerm;
  key[1] = Argument(term, key[0], 0, first);
  key[2] = Argument(term, key[0], 1, second);
  key[3] = Argument(term, key[0], 2, other);
  key[4] = Argument(first, key[1], 0, other);
  key[5] = Argument(first, key[1], 1, other);
  key[6] = Argument(second, key[2], 0, other);
  key[7] = Argument(second, key[2], 1, other);
  return key;
}

bool FingerprintIndex::Fits(Fit fit, std::int32_t query, std::int32_t indexed) {
  if (query == indexed) return true;
  const bool query_open = query == kVariable || query == kBelowVariable;
  const bool indexed_open = indexed == kVariable || indexed == kBelowVariable;
  const auto specializes = [](std::int32_t general, std::int32_t special) {
    return general == kBelowVariable || special >= 0 || special == kVariable;
  };
  switch (fit) {
    case Fit::kInstance:
      return query_open && specializes(query, indexed);
    case Fit::kGeneralization:
      return indexed_open && specializes(indexed, query);
    case Fit::kUnifiable:
      if (!query_open && !indexed_open) return false;
      return query == kBelowVariable || indexed == kBelowVariable ||
             (query != kAbsent && indexed != kAbsent);
  }
  return true;
}

void FingerprintIndex::Insert(const Occurrence& occurrence) {
  trie_.Insert(Fingerprint(occurrence.term), occurrence);
}

void FingerprintIndex::Erase(std::span<const TermId> terms, ClauseId clause) {
  keys_.clear();
  for (const TermId term : terms) keys_.push_back(Fingerprint(term));
  std::ranges::sort(keys_);
  keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  for (const Trie::Key& key : keys_) {
    trie_.Erase(key, [&](const Occurrence& o) { return o.clause == clause; });
  }
}

}  // namespace latchwork::pttp::saturation

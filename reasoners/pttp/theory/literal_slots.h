// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_LITERAL_SLOTS_H_
#define LATCHWORK_PTTP_LITERAL_SLOTS_H_

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/pttp/terms/word.h"
#include "reasoners/pttp/theory/program.h"

namespace latchwork::pttp {

inline std::span<const Word> ArgumentsOf(const CompiledLiteral& literal) {
  return {literal.arguments, literal.arity};
}

/// Visits the slots of a clause template, with repetitions.
template <typename Visit>
void VisitSlots(Word word, Visit&& visit) {
  std::vector<Word> left = {word};
  while (!left.empty()) {
    const Word next = left.back();
    left.pop_back();
    if (TagOf(next) == Tag::kSlot) visit(NumberOf(next));
    if (TagOf(next) != Tag::kTemplate) continue;
    const Word* block = AddressOf(next);
    for (std::size_t i = ArityOf(block[0]); i > 0; --i) left.push_back(block[i]);
  }
}

inline bool Contains(Word word, std::uint32_t slot) {
  bool found = false;
  VisitSlots(word, [&](std::uint32_t other) { found = found || other == slot; });
  return found;
}

/// `but`: an argument that is not looked at.
inline bool Contains(const CompiledLiteral& literal, std::uint32_t slot,
                     std::uint32_t but = 0xffffffffU) {
  for (std::uint32_t i = 0; i < literal.arity; ++i) {
    if (i != but && Contains(literal.arguments[i], slot)) return true;
  }
  return false;
}

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_LITERAL_SLOTS_H_

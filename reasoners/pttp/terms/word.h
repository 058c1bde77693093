// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_WORD_H_
#define LATCHWORK_PTTP_WORD_H_

#include <bit>
#include <cstddef>
#include <cstdint>

namespace latchwork::pttp {

/// A term inside the engine: a tag in the low three bits, the rest an address or a number. Numbers
/// are boxed: the address is that of a word with their bits. Words are compared and hashed by what
/// they mean, never by address.
using Word = std::uint64_t;

enum class Tag : unsigned {
  kReference = 0,  ///< Address of a variable's cell; a cell that refers to itself is unbound.
  kConstant = 1,   ///< Functor number.
  kInteger = 2,    ///< Address of 64 bits.
  kReal = 3,       ///< Address of 64 bits.
  kCompound = 4,   ///< Address of a header followed by the arguments.
  kSlot = 5,       ///< Clause templates only: number of a clause variable.
  kTemplate = 6,   ///< Clause templates only: address of a header and arguments with slots in them.
  kHeader = 7,     ///< Functor number (upper half) and arity of a compound term.
};

inline Tag TagOf(Word word) { return static_cast<Tag>(word & 7U); }
inline Word* AddressOf(Word word) { return std::bit_cast<Word*>(word & ~Word{7}); }
inline Word Tagged(Tag tag, const Word* address) {
  return std::bit_cast<Word>(address) | static_cast<Word>(tag);
}
inline Word Reference(const Word* cell) { return std::bit_cast<Word>(cell); }
inline Word ConstantWord(std::uint32_t functor) {
  return (Word{functor} << 32U) | static_cast<Word>(Tag::kConstant);
}
inline Word SlotWord(std::uint32_t slot) {
  return (Word{slot} << 32U) | static_cast<Word>(Tag::kSlot);
}
inline std::uint32_t NumberOf(Word word) { return static_cast<std::uint32_t>(word >> 32U); }
inline Word Header(std::uint32_t functor, std::size_t arity) {
  return (Word{functor} << 32U) | (static_cast<Word>(arity) << 3U) |
         static_cast<Word>(Tag::kHeader);
}
inline std::size_t ArityOf(Word header) { return static_cast<std::uint32_t>(header) >> 3U; }

/// Follows bound variables.
inline Word Dereference(Word word) {
  while (TagOf(word) == Tag::kReference) {
    const Word next = *AddressOf(word);
    if (next == word) return word;
    word = next;
  }
  return word;
}

inline bool IsNumber(Word word) {
  return TagOf(word) == Tag::kInteger || TagOf(word) == Tag::kReal;
}

inline std::uint64_t MixHash(std::uint64_t hash, std::uint64_t value) {
  hash = (hash ^ value) * 0x9e3779b97f4a7c15ULL;
  return hash ^ (hash >> 29U);
}

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_WORD_H_

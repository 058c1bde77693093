// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_MATRIX_TERMS_H_
#define LATCHWORK_PTTP_TABLEAU_MATRIX_TERMS_H_

#include <cstdint>

namespace latchwork::pttp {

/// A term: a tag in the low two bits. 0 is no term.
using Cell = std::uint32_t;

inline constexpr Cell kVariableTag = 0;  ///< In clauses (slot + 1); in the search where it is.
inline constexpr Cell kGroundTag = 1;    ///< Of the matrix, no variables; equal ones are one.
inline constexpr Cell kOpenTag = 2;      ///< Offset of a functor, its arity and its arguments.
inline constexpr Cell kBuiltTag = 3;     ///< The same, without variables, made by the search.

inline constexpr std::uint32_t kBlockHeader = 3;  ///< Hash, functor and arity.

inline Cell TagOfCell(Cell cell) { return cell & 3U; }
inline bool IsVariable(Cell cell) { return TagOfCell(cell) == kVariableTag; }
/// Of terms, also variables.
inline bool IsGround(Cell cell) { return (cell & kGroundTag) != 0; }
inline Cell CellOfSlot(std::uint32_t slot) { return (slot + 1) << 2U; }
inline std::uint32_t SlotOfCell(Cell cell) { return (cell >> 2U) - 1; }
/// The functor, the number of arguments and the arguments of a term that is no variable.
inline const Cell* BlockOfCell(const Cell* cells, Cell cell) { return cells + (cell >> 2U); }
/// A number that equal terms without variables have in common.
inline std::uint32_t HashOfGround(const Cell* cells, Cell cell) {
  return BlockOfCell(cells, cell)[-1];
}
inline std::uint32_t AddToHash(std::uint32_t hash, std::uint32_t next) {
  hash = (hash ^ next) * 0x9e3779b1U;
  return hash ^ (hash >> 15U);
}

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_MATRIX_TERMS_H_

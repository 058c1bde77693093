// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_MATRIX_TERMS_H_
#define LATCHWORK_PTTP_TABLEAU_MATRIX_TERMS_H_

#include <cstdint>

namespace latchwork::pttp {

/// A term of the matrix: a tag in the low two bits. 0 is no term.
using Cell = std::uint32_t;

inline constexpr Cell kVariableTag = 0;  ///< (slot + 1) of the clause.
inline constexpr Cell kGroundTag = 1;    ///< Without variables; equal ones share an offset.
inline constexpr Cell kOpenTag = 2;      ///< Offset of a functor, its arity and its arguments.

inline Cell TagOfCell(Cell cell) { return cell & 3U; }
inline bool IsVariable(Cell cell) { return TagOfCell(cell) == kVariableTag; }
/// Of terms, also variables.
inline bool IsGround(Cell cell) { return (cell & kGroundTag) != 0; }
inline Cell CellOfSlot(std::uint32_t slot) { return (slot + 1) << 2U; }
inline std::uint32_t SlotOfCell(Cell cell) { return (cell >> 2U) - 1; }
/// The functor, the number of arguments and the arguments of a term that is no variable.
inline const Cell* BlockOfCell(const Cell* cells, Cell cell) { return cells + (cell >> 2U); }

/// An instance of a term of the matrix: its cell and where its clause's copy is.
struct Instance {
  Cell cell = 0;
  std::uint32_t base = 0;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_MATRIX_TERMS_H_

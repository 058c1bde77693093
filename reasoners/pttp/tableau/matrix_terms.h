// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_MATRIX_TERMS_H_
#define LATCHWORK_PTTP_TABLEAU_MATRIX_TERMS_H_

#include <cstdint>

namespace latchwork::pttp {

/// A term of the matrix: a tag in the low two bits. 0 is no term.
using Cell = std::uint32_t;

inline constexpr Cell kVariableTag = 0;  ///< (slot + 1) of the clause.
inline constexpr Cell kConstantTag = 1;  ///< Functor.
inline constexpr Cell kOpenTag = 2;      ///< Offset of a functor, its arity and its arguments.
inline constexpr Cell kGroundTag = 3;  ///< The same without variables; equal ones share an offset.

inline Cell TagOfCell(Cell cell) { return cell & 3U; }
inline Cell CellOfSlot(std::uint32_t slot) { return (slot + 1) << 2U; }
inline std::uint32_t SlotOfCell(Cell cell) { return (cell >> 2U) - 1; }
inline std::uint32_t OffsetOfCell(Cell cell) { return cell >> 2U; }
/// Of a term that is no variable.
inline std::uint32_t FunctorOfCell(const Cell* cells, Cell cell) {
  const std::uint32_t offset = OffsetOfCell(cell);
  return TagOfCell(cell) == kConstantTag ? offset : cells[offset];
}

/// An instance of a term of the matrix: its cell and where its clause's variables begin.
struct Instance {
  Cell cell = 0;
  std::uint32_t base = 0;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_MATRIX_TERMS_H_

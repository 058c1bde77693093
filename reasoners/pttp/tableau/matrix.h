// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_MATRIX_H_
#define LATCHWORK_PTTP_TABLEAU_MATRIX_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>
#include <vector>

#include "latchwork/logic/clause.h"
#include "reasoners/pttp/strategy.h"

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

/// A literal as it stands in its clause, an element of the matrix.
struct MatrixLiteral {
  std::uint32_t key = 0;        ///< Predicate with sign: 2 * predicate + positive.
  std::uint32_t arguments = 0;  ///< Offset of its argument cells.
  std::uint32_t arity = 0;
};

/// A way into a clause: through its literal `head`, which closes the goal's branch. The literals
/// of `body` are then open.
struct Entry {
  std::uint32_t head = 0;
  std::uint32_t body = 0;  ///< Offset in Matrix::bodies.
  std::uint32_t size = 0;
  std::uint32_t slots = 0;
  std::uint32_t clause = 0;
  bool linear = false;  ///< No variable twice in the head.
  bool ground = false;
};

/// What a goal may be connected to, with what the first arguments of the head demand.
struct Connection {
  static constexpr std::size_t kKeys = 3;
  std::uint32_t entry = 0;
  std::array<std::uint32_t, kKeys> keys{};
};

/// The connections of a literal, best first; the first `free` of them are with units and ground
/// clauses.
struct ConnectionList {
  const Connection* first = nullptr;
  std::uint32_t size = 0;
  std::uint32_t free = 0;
};

/// A set of clauses compiled for the tableau: terms in one flat array, every way into every clause,
/// and, found when first asked for, what each literal can be connected to.
class Matrix {
 public:
  Matrix(std::span<const logic::Clause> clauses, const Strategy& strategy);

  const Cell* cells() const { return cells_.data(); }
  const MatrixLiteral& literal(std::uint32_t index) const { return literals_[index]; }
  const Entry& entry(std::uint32_t index) const { return entries_[index]; }
  std::uint32_t number(const Entry& entry) const {
    return static_cast<std::uint32_t>(&entry - entries_.data());
  }
  /// `place`: Entry::body and on.
  std::uint32_t body_literal(std::uint32_t place) const { return bodies_[place]; }
  /// The literals of a clause as it was given.
  std::ranges::iota_view<std::uint32_t, std::uint32_t> ClauseLiterals(std::uint32_t clause) const {
    const ClauseRange& range = clauses_[clause];
    return {range.first, range.first + range.count};
  }
  logic::Symbol predicate(std::uint32_t key) const { return predicates_[key / 2]; }
  const ConnectionList& Connections(std::uint32_t literal) {
    const ConnectionList& list = connections_[literal];
    if (list.first == nullptr) FindConnections(literal);
    return list;
  }
  /// The start clauses of the strategy: entries without a head, best first.
  const std::vector<std::uint32_t>& starts() const { return starts_; }
  /// Whether every minimal refutation of the clauses has a start clause among `starts`.
  bool starts_are_complete() const { return starts_are_complete_; }

  /// The constant or, as a constant, the function symbol with this number.
  const logic::Term& functor(std::uint32_t number) const { return functors_[number]; }
  std::size_t bytes() const;

 private:
  struct ClauseRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t slots = 0;
    bool ground = true;
  };

  void AddEntries(const Strategy& strategy);
  std::uint32_t AddEntry(const ClauseRange& clause, std::uint32_t head, const Strategy& strategy);
  void ChooseStarts(std::span<const logic::Clause> clauses, const Strategy& strategy);
  void FindConnections(std::uint32_t literal);
  bool IsLinear(const MatrixLiteral& literal, std::uint32_t slots) const;
  std::uint32_t KeyOf(Cell cell) const;
  bool CanConnect(const MatrixLiteral& goal, const MatrixLiteral& head) const;

  std::vector<Cell> cells_;
  std::vector<logic::Term> functors_;
  std::vector<MatrixLiteral> literals_;
  std::vector<ClauseRange> clauses_;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> bodies_;
  std::vector<std::vector<std::uint32_t>> entries_of_key_;
  std::vector<std::uint32_t> ways_;  ///< Number of literals, by key.
  std::vector<ConnectionList> connections_;
  std::vector<std::vector<Connection>> found_;
  std::vector<std::uint32_t> starts_;
  std::uint32_t keys_ = 0;
  std::vector<logic::Symbol> predicates_;
  bool starts_are_complete_ = false;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_MATRIX_H_

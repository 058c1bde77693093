// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_MATRIX_H_
#define LATCHWORK_PTTP_TABLEAU_MATRIX_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <ranges>
#include <span>
#include <vector>

#include "latchwork/logic/clause.h"
#include "reasoners/pttp/strategies/strategy.h"
#include "reasoners/pttp/tableau/fingerprint.h"
#include "reasoners/pttp/tableau/literal_coder.h"
#include "reasoners/pttp/tableau/matrix_terms.h"

namespace latchwork::pttp {

struct Entry;

/// What a goal may be connected to.
struct Connection {
  Fingerprint head;
  const Entry* entry = nullptr;
};

/// A literal as it stands in its clause, an element of the matrix. Its connections are best first,
/// those with units and ground clauses end at `free_end`.
struct MatrixLiteral {
  std::uint32_t key = 0;        ///< Predicate with sign: 2 * predicate + positive.
  std::uint32_t arguments = 0;  ///< Offset of its argument cells.
  std::uint32_t arity = 0;
  std::uint32_t words = 0;  ///< How many cells its arguments take, with all that is in them.
  TermCode code;            ///< Of its compound arguments.
  const Probe* probes = nullptr;
  const Probe* probes_end = nullptr;
  Fingerprint print;                  ///< Without its probes.
  const Connection* first = nullptr;  ///< Null as long as nobody asked for them.
  const Connection* free_end = nullptr;
  const Connection* end = nullptr;
};

/// A way into a clause: through its literal `head`, which closes the goal's branch. The literals
/// of `body`, which null ends, are then open.
struct Entry {
  const HeadOperation* head = nullptr;
  const MatrixLiteral* const* body = nullptr;  ///< Null until something is connected to it.
  std::uint32_t slots = 0;
  std::uint32_t words = 0;  ///< How many cells its head may need.
  std::uint32_t clause = 0;
  bool unit = false;
  bool free = false;  ///< Not charged for: a unit or ground.
};

/// A set of clauses compiled for the tableau: terms in one flat array, every way into every clause,
/// and, found when first asked for, what each literal can be connected to.
class Matrix {
 public:
  Matrix(std::span<const logic::Clause> clauses, const Strategy& strategy);
  ~Matrix() = default;
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;
  Matrix(Matrix&&) = default;
  Matrix& operator=(Matrix&&) = default;

  const Cell* cells() const { return cells_.data(); }
  std::span<const Cell> all_cells() const { return cells_; }
  const Cell* codes() const { return codes_.data(); }
  /// Sees to the connections of a literal.
  void Connect(const MatrixLiteral& literal) {
    if (literal.first == nullptr) FindConnections(literal);
  }
  /// The literals of a clause as it was given.
  std::span<const MatrixLiteral> ClauseLiterals(std::uint32_t clause) const {
    const ClauseRange& range = clauses_[clause];
    return {literals_.data() + range.first, range.count};
  }
  logic::Symbol predicate(std::uint32_t key) const { return predicates_[key / 2]; }
  /// The start clauses of the strategy: entries without a head, best first.
  const std::vector<const Entry*>& starts() const { return starts_; }
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

  /// A clause by one of its literals.
  struct Way {
    const MatrixLiteral* head = nullptr;
    const Entry* entry = nullptr;
  };

  void AddLiterals(std::span<const logic::Clause> clauses);
  void Reserve();
  void AddCode();
  void AddEntries();
  const Entry* AddEntry(const ClauseRange& clause, const MatrixLiteral* head);
  void AddBody(const Entry& of, const MatrixLiteral* head);
  const MatrixLiteral** RoomForBody(std::size_t size);
  void ChooseStarts(std::span<const logic::Clause> clauses, const Strategy& strategy);
  MatrixLiteral& Representative(MatrixLiteral& literal);
  void FindConnections(const MatrixLiteral& goal);
  bool CanConnect(const MatrixLiteral& goal, const MatrixLiteral& head) const;
  void AddFingerprints();

  BodyOrder order_;
  std::vector<Cell> cells_;
  std::vector<logic::Term> functors_;
  std::vector<MatrixLiteral> literals_;
  std::vector<ClauseRange> clauses_;
  std::vector<Probe> probes_;
  std::vector<Entry> entries_;
  std::vector<Cell> codes_;
  std::vector<HeadOperation> operations_;
  std::vector<std::uint32_t> heads_;  ///< Of each literal, its first operation.
  std::vector<std::vector<const MatrixLiteral*>> bodies_;  ///< Filled as far as they reserved.
  std::size_t body_bytes_ = 0;
  std::vector<std::vector<Way>> ways_of_key_;
  std::vector<std::vector<Connection>> connections_;
  std::map<std::vector<Cell>, MatrixLiteral*> representatives_;  ///< Of literals without variables.
  std::vector<const Entry*> starts_;
  std::uint32_t keys_ = 0;
  std::vector<logic::Symbol> predicates_;
  bool starts_are_complete_ = false;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_MATRIX_H_

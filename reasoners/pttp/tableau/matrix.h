// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_MATRIX_H_
#define LATCHWORK_PTTP_TABLEAU_MATRIX_H_

#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>
#include <vector>

#include "latchwork/logic/clause.h"
#include "reasoners/pttp/strategy.h"
#include "reasoners/pttp/tableau/fingerprint.h"
#include "reasoners/pttp/tableau/matrix_terms.h"

namespace latchwork::pttp {

/// What a goal may be connected to.
struct Connection {
  Fingerprint head;
  std::uint32_t entry = 0;
};

/// A variable whose value is a part of a goal's fingerprint.
struct Probe {
  Cell variable = 0;
  std::uint16_t argument = kNone;                ///< The argument that it is.
  std::uint8_t place = Fingerprint::kPlaces;     ///< kPlaces: none.
  std::uint8_t below = Fingerprint::kPlaces;     ///< Of the first argument of its value.

  static constexpr std::uint16_t kNone = 0xffff;
};

/// A literal as it stands in its clause, an element of the matrix. Its connections, found when
/// first asked for, are best first: `free` of them are with units and ground clauses.
struct MatrixLiteral {
  std::uint32_t key = 0;        ///< Predicate with sign: 2 * predicate + positive.
  std::uint32_t arguments = 0;  ///< Offset of its argument cells.
  std::uint32_t arity = 0;
  std::uint32_t size = 0;
  std::uint32_t free = 0;
  std::uint32_t probe_count = 0;
  const Connection* first = nullptr;
  const Probe* probes = nullptr;
  Fingerprint print;  ///< Without its probes.
};

/// What unification does at an argument of a head, whose clause copy is new.
enum class HeadStep : std::uint8_t {
  kFirst,   ///< A variable that occurs here for the first time: it gets the goal's argument.
  kAtomic,  ///< A constant or a term without variables.
  kNew,     ///< A term whose variables are all new and different: no occurs check.
  kAny,
};

struct HeadArgument {
  Cell cell = 0;
  HeadStep step = HeadStep::kAny;
};

/// A way into a clause: through its literal `head`, which closes the goal's branch. The literals
/// of the body are then open.
struct Entry {
  std::uint32_t head = 0;
  std::uint32_t arguments = 0;  ///< Where Matrix::head_arguments begin.
  std::uint32_t body = 0;       ///< The place of its first literal.
  std::uint32_t slots = 0;
  std::uint32_t clause = 0;
  bool unit = false;
  bool free = false;  ///< Not charged for: a unit or ground.
};

/// A set of clauses compiled for the tableau: terms in one flat array, every way into every clause,
/// and, found when first asked for, what each literal can be connected to.
class Matrix {
 public:
  static constexpr std::uint32_t kBodyEnd = 0xffffffffU;

  Matrix(std::span<const logic::Clause> clauses, const Strategy& strategy);

  const Cell* cells() const { return cells_.data(); }
  const MatrixLiteral& literal(std::uint32_t index) const { return literals_[index]; }
  /// The same with its connections.
  const MatrixLiteral& goal(std::uint32_t index) {
    const MatrixLiteral& literal = literals_[index];
    if (literal.first == nullptr) FindConnections(index);
    return literal;
  }
  const Entry& entry(std::uint32_t index) const { return entries_[index]; }
  const HeadArgument* head_arguments(const Entry& entry) const {
    return head_arguments_.data() + entry.arguments;
  }
  /// The literal at a place of a body; the last one is followed by kBodyEnd.
  std::uint32_t body_literal(std::uint32_t place) const { return bodies_[place]; }
  /// The literals of a clause as it was given.
  std::ranges::iota_view<std::uint32_t, std::uint32_t> ClauseLiterals(std::uint32_t clause) const {
    const ClauseRange& range = clauses_[clause];
    return {range.first, range.first + range.count};
  }
  logic::Symbol predicate(std::uint32_t key) const { return predicates_[key / 2]; }
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
  void AddHeadArguments(Entry& entry);
  bool TakesNewOnly(Cell argument, std::vector<bool>& seen) const;
  Fingerprint FingerprintOf(const MatrixLiteral& literal) const;
  void AddProbes();
  void AddProbes(const MatrixLiteral& literal, std::uint64_t places);
  bool CanConnect(const MatrixLiteral& goal, const MatrixLiteral& head) const;

  std::vector<Cell> cells_;
  std::vector<logic::Term> functors_;
  std::vector<MatrixLiteral> literals_;
  std::vector<ClauseRange> clauses_;
  std::vector<Entry> entries_;
  std::vector<Probe> probes_;
  std::vector<HeadArgument> head_arguments_;
  std::vector<std::uint32_t> bodies_;
  std::vector<std::vector<std::uint32_t>> entries_of_key_;
  std::vector<std::uint32_t> ways_;  ///< Number of literals, by key.
  std::vector<std::vector<Connection>> found_;
  std::vector<std::uint32_t> starts_;
  std::uint32_t keys_ = 0;
  std::vector<logic::Symbol> predicates_;
  bool starts_are_complete_ = false;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_MATRIX_H_

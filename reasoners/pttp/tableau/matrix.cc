// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tableau/matrix.h"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <utility>

namespace latchwork::pttp {
namespace {

using logic::Clause;
using logic::Term;

constexpr std::uint32_t kNoHead = 0xffffffffU;

/// Compiles clauses into cells; only needed while a matrix is made.
class CellWriter {
 public:
  CellWriter(std::vector<Cell>& cells, std::vector<logic::Term>& functors)
      : cells_(cells), functors_(functors) {}

  Cell Write(const Term& term) {
    if (term.kind() != Term::Kind::kCompound) return WriteAtomic(term);
    std::vector<Pending> stack;
    stack.push_back({&term, {}});
    for (;;) {
      Pending& top = stack.back();
      const auto arguments = top.term->arguments();
      if (top.cells.size() < arguments.size()) {
        const Term& next = arguments[top.cells.size()];
        if (next.kind() == Term::Kind::kCompound) {
          stack.push_back({&next, {}});
        } else {
          top.cells.push_back(WriteAtomic(next));
        }
        continue;
      }
      const Cell made = WriteCompound(*top.term, std::move(top.cells));
      stack.pop_back();
      if (stack.empty()) return made;
      stack.back().cells.push_back(made);
    }
  }

 private:
  struct Pending {
    const Term* term;
    std::vector<Cell> cells;
  };

  Cell WriteAtomic(const Term& term) {
    if (term.is_variable()) return CellOfSlot(term.variable());
    return (Functor(term, 0) << 2U) | kConstantTag;
  }

  Cell WriteCompound(const Term& term, std::vector<Cell> arguments) {
    const bool ground = std::all_of(arguments.begin(), arguments.end(), [](Cell cell) {
      return TagOfCell(cell) == kConstantTag || TagOfCell(cell) == kGroundTag;
    });
    const std::uint32_t functor =
        Functor(Term::Constant(term.symbol()), static_cast<std::uint32_t>(arguments.size()));
    arguments.insert(arguments.begin(), functor);
    if (ground) {
      if (const auto known = ground_.find(arguments); known != ground_.end()) return known->second;
    }
    const auto offset = static_cast<std::uint32_t>(cells_.size());
    cells_.push_back(functor);
    cells_.push_back(static_cast<Cell>(arguments.size() - 1));
    cells_.insert(cells_.end(), arguments.begin() + 1, arguments.end());
    const Cell made = (offset << 2U) | (ground ? kGroundTag : kOpenTag);
    if (ground) ground_.emplace(std::move(arguments), made);
    return made;
  }

  /// Functors are numbered from 1: 0 demands nothing.
  std::uint32_t Functor(const Term& head, std::uint32_t arity) {
    const auto [place, added] =
        numbers_.try_emplace({head, arity}, static_cast<std::uint32_t>(functors_.size()));
    if (added) functors_.push_back(head);
    return place->second;
  }

  std::vector<Cell>& cells_;
  std::vector<Term>& functors_;
  std::map<std::pair<Term, std::uint32_t>, std::uint32_t> numbers_;
  std::map<std::vector<Cell>, Cell> ground_;
};

}  // namespace

Matrix::Matrix(std::span<const Clause> clauses, const Strategy& strategy) {
  cells_.push_back(0);
  functors_.emplace_back();
  CellWriter writer(cells_, functors_);
  std::map<logic::PredicateName, std::uint32_t> predicates;
  for (const Clause& clause : clauses) {
    ClauseRange range;
    range.first = static_cast<std::uint32_t>(literals_.size());
    range.count = static_cast<std::uint32_t>(clause.literals.size());
    range.slots = static_cast<std::uint32_t>(clause.variable_names.size());
    for (const logic::Literal& literal : clause.literals) {
      const auto number = static_cast<std::uint32_t>(predicates.size());
      const std::uint32_t predicate =
          predicates.try_emplace(NameOf(literal.atom), number).first->second;
      if (predicate == number) predicates_.push_back(literal.atom.predicate());
      MatrixLiteral made;
      made.key = 2 * predicate + (literal.positive ? 1U : 0U);
      made.arity = static_cast<std::uint32_t>(literal.atom.arity());
      std::vector<Cell> arguments;
      for (const Term& argument : literal.atom.arguments()) {
        arguments.push_back(writer.Write(argument));
        if (TagOfCell(arguments.back()) == kVariableTag ||
            TagOfCell(arguments.back()) == kOpenTag) {
          range.ground = false;
        }
      }
      made.arguments = static_cast<std::uint32_t>(cells_.size());
      cells_.insert(cells_.end(), arguments.begin(), arguments.end());
      literals_.push_back(made);
    }
    clauses_.push_back(range);
  }
  keys_ = 2 * static_cast<std::uint32_t>(predicates.size());
  AddEntries(strategy);
  connections_.resize(literals_.size());
  ChooseStarts(clauses, strategy);
}

std::uint32_t Matrix::AddEntry(const ClauseRange& clause, std::uint32_t head,
                               const Strategy& strategy) {
  Entry entry;
  entry.head = head;
  entry.slots = clause.slots;
  entry.ground = clause.ground;
  entry.clause = static_cast<std::uint32_t>(&clause - clauses_.data());
  entry.body = static_cast<std::uint32_t>(bodies_.size());
  for (std::uint32_t i = 0; i < clause.count; ++i) {
    if (clause.first + i != head) bodies_.push_back(clause.first + i);
  }
  entry.size = static_cast<std::uint32_t>(bodies_.size()) - entry.body;
  const auto begin = bodies_.begin() + entry.body;
  if (strategy.order == BodyOrder::kReversed) std::reverse(begin, bodies_.end());
  if (strategy.order == BodyOrder::kFewest) {
    std::stable_sort(begin, bodies_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return ways_[literals_[a].key ^ 1U] < ways_[literals_[b].key ^ 1U];
    });
  }
  if (head != kNoHead) entry.linear = IsLinear(literals_[head], clause.slots);
  entries_.push_back(entry);
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

void Matrix::AddEntries(const Strategy& strategy) {
  ways_.assign(keys_, 0);
  for (const MatrixLiteral& literal : literals_) ++ways_[literal.key];
  entries_of_key_.resize(keys_);
  for (const ClauseRange& clause : clauses_) {
    for (std::uint32_t i = 0; i < clause.count; ++i) {
      const std::uint32_t head = clause.first + i;
      entries_of_key_[literals_[head].key].push_back(AddEntry(clause, head, strategy));
    }
  }
  for (auto& entries : entries_of_key_) {
    std::stable_sort(entries.begin(), entries.end(), [&](std::uint32_t a, std::uint32_t b) {
      return entries_[a].size < entries_[b].size;
    });
  }
}

bool Matrix::IsLinear(const MatrixLiteral& literal, std::uint32_t slots) const {
  std::vector<bool> seen(slots, false);
  std::vector<Cell> visits(cells_.begin() + literal.arguments,
                           cells_.begin() + literal.arguments + literal.arity);
  while (!visits.empty()) {
    const Cell cell = visits.back();
    visits.pop_back();
    if (TagOfCell(cell) == kVariableTag) {
      if (seen[SlotOfCell(cell)]) return false;
      seen[SlotOfCell(cell)] = true;
    } else if (TagOfCell(cell) == kOpenTag) {
      const auto block = cells_.begin() + OffsetOfCell(cell);
      visits.insert(visits.end(), block + 2, block + 2 + block[1]);
    }
  }
  return true;
}

std::uint32_t Matrix::KeyOf(Cell cell) const {
  switch (TagOfCell(cell)) {
    case kVariableTag:
      return 0;
    case kConstantTag:
      return OffsetOfCell(cell);
    default:
      return cells_[OffsetOfCell(cell)];
  }
}

/// A quick test without variables bound: no functor in the way.
bool Matrix::CanConnect(const MatrixLiteral& goal, const MatrixLiteral& head) const {
  std::vector<std::pair<Cell, Cell>> visits;
  for (std::uint32_t i = 0; i < goal.arity; ++i) {
    visits.emplace_back(cells_[goal.arguments + i], cells_[head.arguments + i]);
  }
  while (!visits.empty()) {
    const auto [a, b] = visits.back();
    visits.pop_back();
    if (a == b || KeyOf(a) == 0 || KeyOf(b) == 0) continue;
    if (KeyOf(a) != KeyOf(b)) return false;
    if (TagOfCell(a) == kConstantTag) continue;
    if (TagOfCell(a) == kGroundTag && TagOfCell(b) == kGroundTag) return false;
    const std::uint32_t left = OffsetOfCell(a);
    const std::uint32_t right = OffsetOfCell(b);
    for (std::uint32_t i = 0; i < cells_[left + 1]; ++i) {
      visits.emplace_back(cells_[left + 2 + i], cells_[right + 2 + i]);
    }
  }
  return true;
}

void Matrix::FindConnections(std::uint32_t literal) {
  const MatrixLiteral& goal = literals_[literal];
  std::vector<Connection>& found = found_.emplace_back();
  for (const std::uint32_t entry : entries_of_key_[goal.key ^ 1U]) {
    const MatrixLiteral& head = literals_[entries_[entry].head];
    if (!CanConnect(goal, head)) continue;
    Connection connection;
    connection.entry = entry;
    for (std::uint32_t i = 0; i < std::min<std::uint32_t>(goal.arity, Connection::kKeys); ++i) {
      connection.keys[i] = KeyOf(cells_[head.arguments + i]);
    }
    found.push_back(connection);
  }
  const auto bound = std::stable_partition(found.begin(), found.end(), [&](const Connection& way) {
    return entries_[way.entry].size == 0 || entries_[way.entry].ground;
  });
  const auto free = static_cast<std::uint32_t>(bound - found.begin());
  found.reserve(1);  // So that there is an address, which says that it was looked for.
  connections_[literal] = {found.data(), static_cast<std::uint32_t>(found.size()), free};
}

void Matrix::ChooseStarts(std::span<const Clause> clauses, const Strategy& strategy) {
  const bool wanted_sign = strategy.start == Start::kPositive;
  std::vector<std::uint32_t> conjectures;
  std::vector<std::uint32_t> others;
  for (std::uint32_t i = 0; i < clauses_.size(); ++i) {
    const bool conjecture = clauses[i].role == logic::Role::kNegatedConjecture;
    const bool pure =
        std::all_of(clauses[i].literals.begin(), clauses[i].literals.end(),
                    [&](const logic::Literal& literal) { return literal.positive == wanted_sign; });
    const bool start = strategy.start == Start::kConjecture ? conjecture : pure;
    if (start) (conjecture ? conjectures : others).push_back(i);
  }
  starts_are_complete_ = strategy.start != Start::kConjecture;
  if (strategy.start == Start::kConjecture && conjectures.empty()) {
    Strategy negative = strategy;
    negative.start = Start::kNegative;
    return ChooseStarts(clauses, negative);
  }
  const auto by_size = [&](std::uint32_t a, std::uint32_t b) {
    return clauses_[a].count < clauses_[b].count;
  };
  std::stable_sort(conjectures.begin(), conjectures.end(), by_size);
  std::stable_sort(others.begin(), others.end(), by_size);
  conjectures.insert(conjectures.end(), others.begin(), others.end());
  for (const std::uint32_t clause : conjectures) {
    starts_.push_back(AddEntry(clauses_[clause], kNoHead, strategy));
  }
}

std::size_t Matrix::bytes() const {
  std::size_t connections = 0;
  for (const auto& found : found_) connections += found.capacity() * sizeof(Connection);
  return connections + cells_.capacity() * sizeof(Cell) +
         literals_.capacity() * sizeof(MatrixLiteral) + entries_.capacity() * sizeof(Entry) +
         bodies_.capacity() * sizeof(std::uint32_t);
}

}  // namespace latchwork::pttp

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
  AddProbes();
  AddEntries(strategy);
  ChooseStarts(clauses, strategy);
}

std::uint32_t Matrix::AddEntry(const ClauseRange& clause, std::uint32_t head,
                               const Strategy& strategy) {
  Entry entry;
  entry.head = head;
  entry.slots = clause.slots;
  entry.clause = static_cast<std::uint32_t>(&clause - clauses_.data());
  entry.body = static_cast<std::uint32_t>(bodies_.size());
  for (std::uint32_t i = 0; i < clause.count; ++i) {
    if (clause.first + i != head) bodies_.push_back(clause.first + i);
  }
  entry.unit = bodies_.size() == entry.body;
  entry.free = entry.unit || clause.ground;
  const auto begin = bodies_.begin() + entry.body;
  if (strategy.order == BodyOrder::kReversed) std::reverse(begin, bodies_.end());
  if (strategy.order == BodyOrder::kFewest) {
    std::stable_sort(begin, bodies_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return ways_[literals_[a].key ^ 1U] < ways_[literals_[b].key ^ 1U];
    });
  }
  bodies_.push_back(kBodyEnd);
  if (head != kNoHead) AddHeadArguments(entry);
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
      return clauses_[entries_[a].clause].count < clauses_[entries_[b].clause].count;
    });
  }
}

/// Whether no variable of an argument occurs in `seen` or twice in itself; they are added to it.
bool Matrix::TakesNewOnly(Cell argument, std::vector<bool>& seen) const {
  bool all_new = true;
  std::vector<Cell> visits{argument};
  while (!visits.empty()) {
    const Cell cell = visits.back();
    visits.pop_back();
    if (TagOfCell(cell) == kVariableTag) {
      all_new = all_new && !seen[SlotOfCell(cell)];
      seen[SlotOfCell(cell)] = true;
    } else if (TagOfCell(cell) == kOpenTag) {
      const auto block = cells_.begin() + OffsetOfCell(cell);
      visits.insert(visits.end(), block + 2, block + 2 + block[1]);
    }
  }
  return all_new;
}

void Matrix::AddHeadArguments(Entry& entry) {
  entry.arguments = static_cast<std::uint32_t>(head_arguments_.size());
  std::vector<bool> seen(entry.slots, false);
  const MatrixLiteral& head = literals_[entry.head];
  for (std::uint32_t i = 0; i < head.arity; ++i) {
    const Cell cell = cells_[head.arguments + i];
    const bool all_new = TakesNewOnly(cell, seen);
    HeadStep step = all_new ? HeadStep::kNew : HeadStep::kAny;
    if (TagOfCell(cell) == kVariableTag && all_new) step = HeadStep::kFirst;
    if (TagOfCell(cell) == kConstantTag || TagOfCell(cell) == kGroundTag) step = HeadStep::kAtomic;
    head_arguments_.push_back({cell, step});
  }
}

Fingerprint Matrix::FingerprintOf(const MatrixLiteral& literal) const {
  Fingerprint print;
  for (std::uint32_t i = 0; i < std::min(literal.arity, Fingerprint::kPlaces); ++i) {
    const Cell cell = cells_[literal.arguments + i];
    if (TagOfCell(cell) == kVariableTag) continue;
    print.Set(i, FunctorOfCell(cells(), cell));
    const std::uint32_t below = Fingerprint::PlaceBelow(literal.arity, i);
    if (TagOfCell(cell) == kConstantTag || below == Fingerprint::kPlaces) continue;
    const Cell* block = cells() + OffsetOfCell(cell);
    for (std::uint32_t j = 0; j < std::min(block[1], Fingerprint::kBelow); ++j) {
      if (TagOfCell(block[2 + j]) == kVariableTag) continue;
      print.Set(below + j, FunctorOfCell(cells(), block[2 + j]));
    }
  }
  return print;
}

/// Goals of a predicate and sign look below those arguments below which some head has a functor.
void Matrix::AddProbes() {
  std::vector<std::uint64_t> known(keys_, 0);
  for (const MatrixLiteral& head : literals_) known[head.key ^ 1U] |= FingerprintOf(head).known();
  std::vector<std::size_t> begins;
  for (MatrixLiteral& literal : literals_) {
    std::uint64_t places = known[literal.key];
    for (std::uint32_t i = 0; i < std::min(literal.arity, Fingerprint::kPlaces); ++i) {
      places |= Fingerprint::Bytes(i, 1);
      const std::uint32_t below = Fingerprint::PlaceBelow(literal.arity, i);
      const std::uint64_t both = Fingerprint::Bytes(below, Fingerprint::kBelow);
      if ((places & both) != 0) places |= both;
    }
    literal.print = FingerprintOf(literal);
    literal.print.Keep(places);
    begins.push_back(probes_.size());
    AddProbes(literal, places);
    literal.probe_count = static_cast<std::uint32_t>(probes_.size() - begins.back());
  }
  for (std::size_t i = 0; i < literals_.size(); ++i) literals_[i].probes = probes_.data() + begins[i];
}

void Matrix::AddProbes(const MatrixLiteral& literal, std::uint64_t places) {
  for (std::uint32_t i = 0; i < literal.arity; ++i) {
    const Cell cell = cells_[literal.arguments + i];
    std::uint32_t below = Fingerprint::PlaceBelow(literal.arity, i);
    if ((places & Fingerprint::Bytes(below, 1)) == 0) below = Fingerprint::kPlaces;
    if (TagOfCell(cell) == kVariableTag) {
      probes_.push_back({cell, static_cast<std::uint16_t>(i),
                         static_cast<std::uint8_t>(std::min(i, Fingerprint::kPlaces)),
                         static_cast<std::uint8_t>(below)});
    } else if (TagOfCell(cell) == kOpenTag && below != Fingerprint::kPlaces) {
      const Cell* block = cells() + OffsetOfCell(cell);
      for (std::uint32_t j = 0; j < std::min(block[1], Fingerprint::kBelow); ++j) {
        if (TagOfCell(block[2 + j]) != kVariableTag) continue;
        probes_.push_back({block[2 + j], Probe::kNone, static_cast<std::uint8_t>(below + j),
                           Fingerprint::kPlaces});
      }
    }
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
    if (a == b || TagOfCell(a) == kVariableTag || TagOfCell(b) == kVariableTag) continue;
    if (FunctorOfCell(cells_.data(), a) != FunctorOfCell(cells_.data(), b)) return false;
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
  MatrixLiteral& goal = literals_[literal];
  std::vector<Connection>& found = found_.emplace_back();
  for (const std::uint32_t entry : entries_of_key_[goal.key ^ 1U]) {
    const MatrixLiteral& head = literals_[entries_[entry].head];
    if (!CanConnect(goal, head)) continue;
    found.push_back({FingerprintOf(head), entry});
  }
  const auto bound = std::stable_partition(
      found.begin(), found.end(), [&](const Connection& way) { return entries_[way.entry].free; });
  found.reserve(1);  // So that there is an address, which says that it was looked for.
  goal.first = found.data();
  goal.size = static_cast<std::uint32_t>(found.size());
  goal.free = static_cast<std::uint32_t>(bound - found.begin());
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

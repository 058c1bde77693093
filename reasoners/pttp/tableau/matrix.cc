// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tableau/matrix.h"

#include <algorithm>
#include <utility>

#include "reasoners/pttp/tableau/cell_writer.h"
#include "reasoners/pttp/tableau/fingerprinter.h"

namespace latchwork::pttp {

using logic::Clause;
using logic::Term;

Matrix::Matrix(std::span<const Clause> clauses, const Strategy& strategy) : order_(strategy.order) {
  cells_.push_back(0);
  AddLiterals(clauses);
  Reserve();
  AddCode();
  AddFingerprints();
  AddEntries();
  ChooseStarts(clauses, strategy);
}

void Matrix::AddLiterals(std::span<const Clause> clauses) {
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
      }
      range.ground = range.ground && std::all_of(arguments.begin(), arguments.end(), IsGround);
      made.arguments = static_cast<std::uint32_t>(cells_.size());
      cells_.insert(cells_.end(), arguments.begin(), arguments.end());
      literals_.push_back(made);
    }
    clauses_.push_back(range);
  }
  keys_ = 2 * static_cast<std::uint32_t>(predicates.size());
}

/// Room for what is pointed to, so that it stays where it is.
void Matrix::Reserve() {
  probes_.reserve(Fingerprint::kPlaces * literals_.size());
  entries_.reserve(literals_.size() + clauses_.size());
}

void Matrix::AddCode() {
  LiteralCoder coder(cells_, codes_, operations_);
  for (const ClauseRange& clause : clauses_) {
    for (std::uint32_t i = clause.first; i < clause.first + clause.count; ++i) {
      MatrixLiteral& literal = literals_[i];
      literal.code = coder.Code(literal.arguments, literal.arity, literal.words);
      literal.words += literal.arity;
      heads_.push_back(static_cast<std::uint32_t>(operations_.size()));
      coder.AddHead(literal.arguments, literal.arity, clause.slots);
    }
  }
}

const Entry* Matrix::AddEntry(const ClauseRange& clause, const MatrixLiteral* head) {
  Entry entry;
  entry.slots = clause.slots;
  entry.clause = static_cast<std::uint32_t>(&clause - clauses_.data());
  entry.unit = clause.count == (head == nullptr ? 0U : 1U);
  entry.free = entry.unit || clause.ground;
  if (head != nullptr) {
    entry.head = operations_.data() + heads_[static_cast<std::size_t>(head - literals_.data())];
    entry.words = head->words;
  }
  return &entries_.emplace_back(entry);
}

/// Not before it is needed: all ways into a clause together are as large as its square.
void Matrix::AddBody(const Entry& of, const MatrixLiteral* head) {
  if (of.body != nullptr) return;
  const std::span<const MatrixLiteral> literals = ClauseLiterals(of.clause);
  const MatrixLiteral** const body = RoomForBody(literals.size() + 1);
  const MatrixLiteral** end = body;
  for (const MatrixLiteral& literal : literals) {
    if (&literal != head) *end++ = &literal;
  }
  *end = nullptr;
  if (order_ == BodyOrder::kReversed) std::reverse(body, end);
  if (order_ == BodyOrder::kFewest) {
    std::stable_sort(body, end, [&](const auto* a, const auto* b) {
      return ways_of_key_[a->key ^ 1U].size() < ways_of_key_[b->key ^ 1U].size();
    });
  }
  entries_[static_cast<std::size_t>(&of - entries_.data())].body = body;
}

const MatrixLiteral** Matrix::RoomForBody(std::size_t size) {
  constexpr std::size_t kBlock = 4096;
  if (bodies_.empty() || bodies_.back().capacity() - bodies_.back().size() < size) {
    bodies_.emplace_back().reserve(std::max(size, kBlock));
    body_bytes_ += bodies_.back().capacity() * sizeof(void*);
  }
  std::vector<const MatrixLiteral*>& block = bodies_.back();
  block.resize(block.size() + size);
  return block.data() + block.size() - size;
}

void Matrix::AddEntries() {
  ways_of_key_.resize(keys_);
  for (const MatrixLiteral& literal : literals_) {
    ways_of_key_[literal.key].push_back({&literal, nullptr});
  }
  std::vector<std::size_t> next(keys_, 0);
  for (const ClauseRange& clause : clauses_) {
    for (const MatrixLiteral& head :
         ClauseLiterals(static_cast<std::uint32_t>(&clause - clauses_.data()))) {
      ways_of_key_[head.key][next[head.key]++].entry = AddEntry(clause, &head);
    }
  }
  for (auto& ways : ways_of_key_) {
    std::stable_sort(ways.begin(), ways.end(), [&](const Way& a, const Way& b) {
      return clauses_[a.entry->clause].count < clauses_[b.entry->clause].count;
    });
  }
}

void Matrix::AddFingerprints() {
  std::vector<std::vector<MatrixLiteral*>> literals_of(keys_ / 2);
  for (MatrixLiteral& literal : literals_) literals_of[literal.key / 2].push_back(&literal);
  for (const std::vector<MatrixLiteral*>& literals : literals_of) {
    const Fingerprinter fingerprinter(cells_, literals);
    for (MatrixLiteral* literal : literals) {
      literal->probes = probes_.data() + probes_.size();
      literal->print = fingerprinter.Take(*literal, probes_);
      literal->probes_end = probes_.data() + probes_.size();
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
    if (a == b || IsVariable(a) || IsVariable(b)) continue;
    const Cell* left = BlockOfCell(cells(), a);
    const Cell* right = BlockOfCell(cells(), b);
    if (left[0] != right[0] || (IsGround(a) && IsGround(b))) return false;
    for (std::uint32_t i = 0; i < left[1]; ++i) visits.emplace_back(left[2 + i], right[2 + i]);
  }
  return true;
}

/// The first of the literals that are the same; the literal itself where it has variables.
MatrixLiteral& Matrix::Representative(MatrixLiteral& literal) {
  const auto begin = cells_.begin() + literal.arguments;
  if (!std::all_of(begin, begin + literal.arity, IsGround)) return literal;
  std::vector<Cell> text{literal.key};
  text.insert(text.end(), begin, begin + literal.arity);
  return *representatives_.try_emplace(std::move(text), &literal).first->second;
}

void Matrix::FindConnections(const MatrixLiteral& goal) {
  MatrixLiteral& literal = literals_[static_cast<std::size_t>(&goal - literals_.data())];
  const MatrixLiteral& same = Representative(literal);
  if (same.first != nullptr) {
    literal.first = same.first;
    literal.free_end = same.free_end;
    literal.end = same.end;
    return;
  }
  std::vector<Connection>& found = connections_.emplace_back();
  for (const Way& way : ways_of_key_[goal.key ^ 1U]) {
    if (!CanConnect(goal, *way.head)) continue;
    AddBody(*way.entry, way.head);
    found.push_back({way.head->print, way.entry});
  }
  const auto free_end = std::stable_partition(
      found.begin(), found.end(), [](const Connection& way) { return way.entry->free; });
  found.reserve(1);  // So that there is an address, which says that it was looked for.
  literal.first = found.data();
  literal.free_end = literal.first + (free_end - found.begin());
  literal.end = literal.first + found.size();
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
    starts_.push_back(AddEntry(clauses_[clause], nullptr));
    AddBody(*starts_.back(), nullptr);
  }
}

std::size_t Matrix::bytes() const {
  std::size_t connections = 0;
  for (const auto& found : connections_) connections += found.capacity() * sizeof(Connection);
  return connections + cells_.capacity() * sizeof(Cell) +
         literals_.capacity() * sizeof(MatrixLiteral) + entries_.capacity() * sizeof(Entry) +
         codes_.capacity() * sizeof(Cell) + operations_.capacity() * sizeof(HeadOperation) +
         probes_.capacity() * sizeof(Probe) + body_bytes_;
}

}  // namespace latchwork::pttp

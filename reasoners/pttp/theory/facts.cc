// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/theory/facts.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "reasoners/pttp/terms/row_set.h"

namespace latchwork::pttp {
namespace {

/// Whether every row that may match this argument has its hash: no variable in the first level.
bool IsKey(Word word) {
  if (TagOf(word) == Tag::kReference) return false;
  if (TagOf(word) != Tag::kCompound) return true;
  const Word* block = AddressOf(word);
  return std::none_of(block + 1, block + 1 + ArityOf(block[0]),
                      [](Word part) { return TagOf(Dereference(part)) == Tag::kReference; });
}

/// Whether a flat ground term is what a cell holds; false for deeper ones, equal or not.
bool Holds(Word cell, const logic::Term& term, Functors& functors) {
  using Kind = logic::Term::Kind;
  switch (term.kind()) {
    case Kind::kInteger:
      return TagOf(cell) == Tag::kInteger &&
             *AddressOf(cell) == std::bit_cast<Word>(term.integer());
    case Kind::kReal:
      return TagOf(cell) == Tag::kReal && *AddressOf(cell) == std::bit_cast<Word>(term.real());
    case Kind::kConstant:
      return cell == ConstantWord(functors.Number(term.symbol(), 0));
    default:
      return false;
  }
}

bool HoldsFlat(Word cell, const logic::Term& term, Functors& functors) {
  if (term.kind() != logic::Term::Kind::kCompound) return Holds(cell, term, functors);
  if (TagOf(cell) != Tag::kCompound) return false;
  const auto arguments = term.arguments();
  const Word* block = AddressOf(cell);
  if (*block != Header(functors.Number(term.symbol(), arguments.size()), arguments.size())) {
    return false;
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!Holds(block[i + 1], arguments[i], functors)) return false;
  }
  return true;
}

/// Writes a number over another one.
Word Rewrite(Word cell, const logic::Term& number) {
  Word* box = AddressOf(cell);
  if (number.kind() == logic::Term::Kind::kInteger) {
    *box = std::bit_cast<Word>(number.integer());
    return Tagged(Tag::kInteger, box);
  }
  *box = std::bit_cast<Word>(number.real() == 0.0 ? 0.0 : number.real());
  return Tagged(Tag::kReal, box);
}

}  // namespace

void FactTable::Clear() {
  rows_ = 0;
  cells_.clear();
  for (Column& column : columns_) column.built = false;
}

Word* FactTable::AddRow() {
  for (Column& column : columns_) column.built = false;
  const std::size_t end = std::size_t{rows_++} * arity_;
  if (cells_.size() < end + arity_) cells_.resize(2 * (end + arity_));
  return cells_.data() + end;
}

std::size_t FactTable::SetRow(const logic::Fact& fact, Functors& functors, Arena& terms) {
  const bool added = filled_ == rows_;
  if (added) {
    AddRow();
    changed_ = true;
  }
  // Cells beyond the rows still own the boxes of their last number.
  Word* cells = cells_.data() + std::size_t{filled_++} * arity_;
  std::size_t garbage = 0;
  const auto arguments = fact.arguments();
  for (std::size_t i = 0; i < arity_; ++i) {
    const logic::Term& argument = arguments[i];
    if (!added && HoldsFlat(cells[i], argument, functors)) continue;
    NoteChange(i);
    if (argument.is_number() && IsNumber(cells[i])) {
      cells[i] = Rewrite(cells[i], argument);
    } else {
      const bool leaves_memory = cells[i] != 0 && argument.kind() != logic::Term::Kind::kConstant;
      if (leaves_memory) ++garbage;
      cells[i] = functors.Import(argument, terms);
    }
  }
  return garbage;
}

bool FactTable::EndBatch() {
  if (filled_ != rows_) {
    rows_ = filled_;
    changed_ = true;
    for (Column& column : columns_) column.built = false;
  }
  return changed_;
}

void FactTable::Build(std::size_t index) {
  Column& column = columns_[index];
  const std::size_t buckets = std::bit_ceil(std::size_t{rows_} * 2);
  column.first.assign(buckets, kNoRow);
  column.next.resize(rows_);
  column.distinct = true;
  for (std::uint32_t i = rows_; i > 0; --i) {
    const std::uint64_t hash = ShallowHash(row(i - 1)[index]);
    std::uint32_t& first = column.first[hash & (buckets - 1)];
    for (std::uint32_t other = first; column.distinct && other != kNoRow;) {
      column.distinct = ShallowHash(row(other)[index]) != hash;
      other = column.next[other];
    }
    column.next[i - 1] = first;
    first = i - 1;
  }
  column.built = true;
}

bool FactTable::TellsRowsApart(std::size_t column) {
  if (rows_ <= kSmall) return rows_ <= 1;
  if (!columns_[column].built) Build(column);
  return columns_[column].distinct;
}

FactTable::Cursor FactTable::FindBy(std::size_t column, Word key) {
  if (rows_ <= kSmall) return All();
  Column& index = columns_[column];
  if (!index.built) Build(column);
  return {this, index.first[ShallowHash(key) & (index.first.size() - 1)], index.next.data()};
}

FactTable::Cursor FactTable::Find(const Word* goal) {
  for (std::size_t i = 0; rows_ > kSmall && i < arity_; ++i) {
    const Word key = Dereference(goal[i]);
    if (IsKey(key)) return FindBy(i, key);
  }
  return All();
}

FactSource& FactStore::AddSource(std::string name) {
  return *sources_.emplace_back(std::make_unique<FactSource>(std::move(name), sources_.size()));
}

void FactStore::Clear(FactSource& source) {
  for (auto& entry : source.tables_) {
    entry.table->Clear();
    NoteChange(source, entry.predicate);
  }
  source.terms_.Clear();
  source.garbage_ = 0;
}

FactSource::Entry& FactStore::EntryOf(FactSource& source, const logic::PredicateName& name) {
  // Facts of one predicate mostly follow each other, or those of a few take turns.
  const std::size_t count = source.tables_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t index =
        source.last_ + i < count ? source.last_ + i : source.last_ + i - count;
    if (source.tables_[index].name != name) continue;
    source.last_ = index;
    return source.tables_[index];
  }
  return AddTable(source, name);
}

FactSource::Entry& FactStore::AddTable(FactSource& source, const logic::PredicateName& name) {
  source.last_ = source.tables_.size();
  AddTable(source, predicates_->Number(name), name);
  return source.tables_.back();
}

FactTable& FactStore::AddHiddenTable(FactSource& source, PredicateId predicate) {
  return AddTable(source, predicate, (*predicates_)[predicate].name);
}

FactTable& FactStore::AddTable(FactSource& source, PredicateId predicate,
                               const logic::PredicateName& name) {
  source.tables_.push_back({name, predicate, std::make_unique<FactTable>(name.arity)});
  if (predicate >= by_predicate_.size()) by_predicate_.resize(predicate + 1);
  auto& entries = by_predicate_[predicate];
  const auto later = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) {
    return entry.source->order_ > source.order_;
  });
  entries.insert(later, {&source, source.tables_.back().table.get()});
  return *source.tables_.back().table;
}

bool FactStore::NoteFacts(PredicateId predicate) {
  return !std::exchange((*predicates_)[predicate].has_facts, true);
}

void FactStore::NoteChange(const FactSource& source, PredicateId predicate) {
  if (source.is_scratch) return;
  if (predicate >= changed_at_.size()) changed_at_.resize(predicate + 1, 0);
  changed_at_[predicate] = ++now_;
}

bool FactStore::Add(FactSource& source, const logic::Fact& fact) {
  if (!fact.is_ground()) {
    throw std::invalid_argument(ToString(fact) + " is not ground, so it is no fact");
  }
  FactSource::Entry& entry = EntryOf(source, NameOf(fact));
  Word* row = entry.table->AddRow();
  for (const logic::Term& argument : fact.arguments()) {
    *row++ = functors_->Import(argument, source.terms_);
  }
  NoteChange(source, entry.predicate);
  return NoteFacts(entry.predicate);
}

bool FactStore::Replace(FactSource& source, std::span<const logic::Fact> facts) {
  constexpr std::size_t kMostGarbage = 4096;
  if (source.garbage_ > kMostGarbage) Clear(source);
  for (auto& entry : source.tables_) entry.table->BeginBatch();
  bool first = false;
  for (const logic::Fact& fact : facts) {
    if (!fact.is_ground()) {
      Clear(source);
      throw std::invalid_argument(ToString(fact) + " is not ground, so it is no fact");
    }
    FactSource::Entry& entry = EntryOf(source, NameOf(fact));
    source.garbage_ += entry.table->SetRow(fact, *functors_, source.terms_);
    first = NoteFacts(entry.predicate) || first;
  }
  for (auto& entry : source.tables_) {
    if (entry.table->EndBatch()) NoteChange(source, entry.predicate);
  }
  return first;
}

}  // namespace latchwork::pttp

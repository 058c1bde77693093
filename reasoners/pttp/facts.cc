// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/facts.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace latchwork::pttp {
namespace {

/// A hash of the outermost part of a ground or partly bound argument.
std::uint64_t KeyHash(Word word) {
  switch (TagOf(word)) {
    case Tag::kInteger:
    case Tag::kReal:
      return MixHash(word & 7U, *AddressOf(word));
    case Tag::kCompound:
      return MixHash(0, *AddressOf(word));
    default:
      return MixHash(0, word);
  }
}

}  // namespace

void FactTable::Clear() {
  rows_ = 0;
  cells_.clear();
  for (Column& column : columns_) column.built = false;
}

Word* FactTable::AddRow() {
  for (Column& column : columns_) column.built = false;
  ++rows_;
  cells_.resize(cells_.size() + arity_);
  return cells_.data() + cells_.size() - arity_;
}

void FactTable::Build(std::size_t index) {
  Column& column = columns_[index];
  const std::size_t buckets = std::bit_ceil(std::size_t{rows_} * 2);
  column.first.assign(buckets, kNoRow);
  column.next.resize(rows_);
  for (std::uint32_t i = rows_; i > 0; --i) {
    std::uint32_t& first = column.first[KeyHash(row(i - 1)[index]) & (buckets - 1)];
    column.next[i - 1] = first;
    first = i - 1;
  }
  column.built = true;
}

FactTable::Cursor FactTable::Find(const Word* goal) {
  if (rows_ == 0) return {};
  if (rows_ > kSmall) {
    for (std::size_t i = 0; i < arity_; ++i) {
      const Word key = Dereference(goal[i]);
      if (TagOf(key) == Tag::kReference) continue;
      if (!columns_[i].built) Build(i);
      const Column& column = columns_[i];
      return {this, column.first[KeyHash(key) & (column.first.size() - 1)],
              static_cast<std::uint32_t>(i)};
    }
  }
  return {this, 0, kNoRow};
}

void FactTable::Advance(Cursor& cursor) {
  if (cursor.column == kNoRow) {
    cursor.row = cursor.row + 1 < cursor.table->rows_ ? cursor.row + 1 : kNoRow;
  } else {
    cursor.row = cursor.table->columns_[cursor.column].next[cursor.row];
  }
}

FactSource& FactStore::AddSource(std::string name) {
  return *sources_.emplace_back(std::make_unique<FactSource>(std::move(name), sources_.size()));
}

void FactStore::Clear(FactSource& source) {
  for (auto& [predicate, table] : source.tables_) table->Clear();
  source.terms_.Clear();
}

FactTable& FactStore::TableOf(FactSource& source, PredicateId predicate, std::size_t arity) {
  for (auto& [id, table] : source.tables_) {
    if (id == predicate) return *table;
  }
  source.tables_.emplace_back(predicate, std::make_unique<FactTable>(arity));
  FactTable& table = *source.tables_.back().second;
  if (predicate >= by_predicate_.size()) by_predicate_.resize(predicate + 1);
  auto& entries = by_predicate_[predicate];
  const auto later = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) {
    return entry.source->order_ > source.order_;
  });
  entries.insert(later, {&source, &table});
  return table;
}

bool FactStore::Add(FactSource& source, const logic::Fact& fact) {
  if (!fact.is_ground()) {
    throw std::invalid_argument(ToString(fact) + " is not ground, so it is no fact");
  }
  const PredicateId predicate = predicates_->Number(NameOf(fact));
  Word* row = TableOf(source, predicate, fact.arity()).AddRow();
  for (const logic::Term& argument : fact.arguments()) {
    *row++ = functors_->Import(argument, source.terms_);
  }
  Predicates::Info& info = (*predicates_)[predicate];
  const bool first = !info.has_facts;
  info.has_facts = true;
  return first;
}

}  // namespace latchwork::pttp

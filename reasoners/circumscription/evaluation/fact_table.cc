// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/evaluation/fact_table.h"

#include <algorithm>

namespace latchwork::circumscription {

FactTable::FactTable(std::size_t arity, std::span<const std::size_t> columns) : arity_(arity) {
  for (const std::size_t column : columns) AddIndex(column);
}

void FactTable::AddIndex(std::size_t column) {
  if (IsIndexed(column)) return;
  indexes_.emplace_back().column = column;
  for (std::uint32_t row = 0; row < size(); ++row) Enter(indexes_.back(), row);
}

bool FactTable::IsIndexed(std::size_t column) const {
  return std::any_of(indexes_.begin(), indexes_.end(),
                     [&](const Index& index) { return index.column == column; });
}

std::uint32_t FactTable::Find(std::span<const Value> cells) const {
  return rows_.Find(HashOf(cells), [&](std::uint32_t row) {
    return std::equal(cells.begin(), cells.end(), Row(row).begin());
  });
}

std::uint32_t FactTable::Insert(std::span<const Value> cells, const FactInfo& info) {
  const std::uint32_t known = Find(cells);
  if (known != kNone) return known;
  const std::uint32_t row = size();
  rows_.Insert(HashOf(cells), row);
  cells_.insert(cells_.end(), cells.begin(), cells.end());
  infos_.push_back(info);
  for (Index& index : indexes_) Enter(index, row);
  return row;
}

void FactTable::Enter(Index& index, std::uint32_t row) {
  const Value& value = Row(row)[index.column];
  const std::uint64_t hash = Mix(0, value);
  const std::uint32_t first = index.firsts.Find(
      hash, [&](std::uint32_t other) { return Row(other)[index.column] == value; });
  index.next.push_back(kNone);
  index.last.push_back(row);
  if (first == kNone) {
    index.firsts.Insert(hash, row);
  } else {
    index.next[index.last[first]] = row;
    index.last[first] = row;
  }
}

const FactTable::Index& FactTable::Of(std::size_t column) const {
  return *std::find_if(indexes_.begin(), indexes_.end(),
                       [&](const Index& index) { return index.column == column; });
}

std::uint32_t FactTable::First(std::size_t column, const Value& value) const {
  return Of(column).firsts.Find(Mix(0, value),
                                [&](std::uint32_t row) { return Row(row)[column] == value; });
}

std::uint32_t FactTable::Next(std::size_t column, std::uint32_t row) const {
  return Of(column).next[row];
}

void FactTable::Clear() {
  cells_.clear();
  infos_.clear();
  rows_.Clear();
  for (Index& index : indexes_) {
    index.firsts.Clear();
    index.next.clear();
    index.last.clear();
  }
}

}  // namespace latchwork::circumscription

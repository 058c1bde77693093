// SPDX-License-Identifier: BSD-3-Clause
// The part of the tables that keeps calls and answers.
#include <algorithm>
#include <utility>

#include "reasoners/pttp/tables/tables.h"

namespace latchwork::pttp {
namespace {

constexpr std::size_t kMostWords = std::size_t{1} << 26U;

}  // namespace

Tables::Table* Tables::FindTable(const TableStep& step, const Word* values, bool& added) {
  added = false;
  if (Table* general = GeneralTable(step); general != nullptr) return general;
  std::uint64_t hash = MixHash(step.call->label, step.call->ground);
  for (std::size_t i = 0; i < step.operands.size(); ++i) {
    hash = MixHash(hash, ShallowHash(values[i]));
  }
  const auto fresh = static_cast<std::uint32_t>(tables_.size());
  const std::uint32_t number = calls_.Enter(
      hash, fresh, [&](std::uint32_t known) { return IsCall(*tables_[known], step, values); });
  added = number == fresh;
  return added ? MakeTable(step, values) : tables_[number];
}

bool Tables::IsCall(const Table& table, const TableStep& step, const Word* values) {
  return table.call->label == step.call->label && table.call->ground == step.call->ground &&
         Agrees(step, values, table.arguments);
}

Tables::Table* Tables::TakeTable(std::size_t arity) {
  if (arity >= pools_.size()) {
    pools_.resize(arity + 1);
    used_.resize(arity + 1, 0);
  }
  auto& pool = pools_[arity];
  if (used_[arity] == pool.size()) pool.push_back(std::make_unique<Table>(arity));
  Table* table = pool[used_[arity]++].get();
  table->rows.Clear();
  table->origins.clear();
  table->consumers.clear();
  return table;
}

Tables::Table* Tables::MakeTable(const TableStep& step, const Word* values) {
  Table* table = TakeTable(step.arity);
  Word* arguments = store_.arena.Allocate(step.arity);
  for (const Operand& operand : step.operands) {
    arguments[operand.argument] = operand.is_fresh() ? Keep(*values) : *values;
    ++values;
  }
  table->call = step.call;
  table->arguments = arguments;
  table->number = static_cast<std::uint32_t>(tables_.size());
  table->state = State::kOpen;
  tables_.push_back(table);
  open_.push_back(table);
  if (step.call->ground == 0) {
    const std::size_t label = step.call->label;
    if (label >= general_.size()) general_.resize(label + 1, nullptr);
    general_[label] = table;
  }
  return table;
}

void Tables::CloseTables(std::size_t first, State state) {
  for (std::size_t i = first; i < open_.size(); ++i) open_[i]->state = state;
  open_.resize(std::min(first, open_.size()));
}

bool Tables::AddAnswer(Table& table, const Word* row, const Origin& origin) {
  if (table.call->whole ? table.IsFull() : !IsNew(table, row)) return false;
  if (store_.arena.reserved_words() + 8 * all_answers_.size() > kMostWords) {
    shop_.meter->Stop(sdk::Limit::kInferences);
  }
  std::copy_n(row, table.rows.arity(), table.rows.AddRow());
  table.origins.push_back(origin);
  for (const std::uint32_t consumer : table.consumers) {
    if (std::exchange(consumers_[consumer].queued, true)) continue;
    agenda_.push_back({nullptr, consumer});
  }
  return true;
}

/// Notes an answer; false when the table has it already.
bool Tables::IsNew(const Table& table, const Word* row) {
  const std::size_t arity = table.rows.arity();
  std::uint64_t hash = table.number;
  for (std::size_t i = 0; i < arity; ++i) hash = MixHash(hash, ShallowHash(row[i]));
  const auto fresh = static_cast<std::uint32_t>(all_answers_.size());
  const std::uint32_t number = answers_.Enter(hash, fresh, [&](std::uint32_t known) {
    const Answer& answer = all_answers_[known];
    if (answer.table != &table) return false;
    const Word* other = table.rows.row(answer.row);
    return std::equal(row, row + arity, other, [&](Word a, Word b) { return AreSame(a, b); });
  });
  if (number != fresh) return false;
  all_answers_.push_back({&table, table.rows.rows()});
  return true;
}

}  // namespace latchwork::pttp

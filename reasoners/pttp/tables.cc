// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tables.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace latchwork::pttp {
namespace {

constexpr std::size_t kDeepestNesting = 4096;
constexpr std::uint32_t kNoConsumer = 0xffffffffU;

}  // namespace

Tables::Tables(const Workshop& shop)
    : shop_(shop), store_(*shop.functors), stack_(*shop.functors), comparer_(stack_.arena) {
  for (Word& word : free_) word = Reference(&word);
}

void Tables::Begin() {
  store_.arena.Clear();
  stack_.arena.Clear();
  calls_.Clear();
  answers_.Clear();
  tables_.clear();
  all_answers_.clear();
  std::fill(general_.begin(), general_.end(), nullptr);
  std::fill(used_.begin(), used_.end(), 0);
  open_.clear();
  consumers_.clear();
  agenda_.clear();
  nesting_ = 0;
}

std::optional<SearchEnd> Tables::Solve(TableProgram& program, const TablePlan& query,
                                       std::span<const Word> given, ProofSink& sink) {
  Run run{&program, &sink};
  const std::size_t first_open = open_.size();
  const std::size_t nesting = nesting_;
  const Arena::Mark mark = stack_.arena.mark();
  Word* slots = stack_.arena.Allocate(query.rule->slots);
  for (std::size_t i = 0; i < given.size(); ++i) slots[i] = Keep(Dereference(given[i]));
  const Body body{&run, &query, nullptr, slots};
  const bool whole = Continue({&body, 0, nullptr, 0});
  stack_.arena.Release(mark);
  nesting_ = nesting;
  CloseTables(first_open, State::kBroken);
  if (run.enough) return SearchEnd::kAccepted;
  if (shop_.meter->stopped()) return SearchEnd::kStopped;
  if (run.unfit || !whole) return std::nullopt;
  return SearchEnd::kExhausted;
}

bool Tables::Unfit(Run& run) {
  run.unfit = true;
  return false;
}

bool Tables::Continue(Place at) {
  const std::vector<TableStep>& steps = at.body->plan->steps;
  for (; at.step < steps.size(); ++at.step) {
    const TableStep& step = steps[at.step];
    Outcome outcome = Outcome::kHolds;
    switch (step.kind) {
      case TableStep::Kind::kArithmetic:
      case TableStep::Kind::kDiffer:
        if (!Count()) return false;
        if (!Holds(step, at.body->slots)) return true;
        break;
      case TableStep::Kind::kUnify:
        outcome = Unify(*at.body, step);
        break;
      case TableStep::Kind::kClosing:
        outcome = Close(at, step);
        break;
      default:
        return Enumerate(at, step);
    }
    if (outcome != Outcome::kHolds) return outcome == Outcome::kFails;
  }
  return Deliver(at);
}

/// Follows every way to solve a step.
bool Tables::Enumerate(const Place& at, const TableStep& step) {
  if (nesting_ == kDeepestNesting) return Unfit(*at.body->run);
  std::array<Word, 32> values;
  ++nesting_;
  const Arena::Mark mark = stack_.arena.mark();
  bool go_on = true;
  if (MakeValues(step, at.body->slots, values.data())) {
    switch (step.kind) {
      case TableStep::Kind::kCall:
        go_on = TryCall(at, step, values.data());
        break;
      case TableStep::Kind::kAttachment:
        go_on = TryComputed(at, step, values.data());
        break;
      default:
        go_on = TryFacts(at, step, values.data());
    }
  }
  stack_.arena.Release(mark);
  --nesting_;
  return go_on;
}

bool Tables::TryRows(const Place& at, const TableStep& step, FactTable& rows,
                     const Origin* origins, const Word* values) {
  const bool binds = !step.pattern.steps.empty();
  Place next{at.body, at.step + 1, at.resting, at.depth};
  auto cursor = step.operands.empty() ? rows.All()
                                      : rows.FindBy(step.operands.front().argument, values[0]);
  for (; cursor.row != kNoRow; FactTable::Advance(cursor)) {
    if (!Count()) return false;
    const Word* row = rows.row(cursor.row);
    if (!Agrees(step, values, row) || !Match(step.pattern, row, at.body->slots)) continue;
    shop_.meter->CountInference();
    if (origins != nullptr) {
      const Origin& origin = origins[cursor.row];
      next.resting = Join(at.resting, origin.resting);
      next.depth = std::max(at.depth, origin.depth);
    }
    if (!Continue(next)) return false;
    if (!binds) return true;  // other rows that agree are the same
  }
  return true;
}

bool Tables::TryFacts(const Place& at, const TableStep& step, const Word* values) {
  if (!step.positive) return true;
  for (const FactStore::Entry& entry : shop_.facts->Tables(step.predicate)) {
    if (!entry.source->enabled) continue;
    if (!TryRows(at, step, *entry.table, nullptr, values)) return false;
  }
  return true;
}

bool Tables::TryCall(const Place& at, const TableStep& step, const Word* values) {
  Run& run = *at.body->run;
  bool added = false;
  Table* table = FindTable(step, values, added);
  if (step.recursive && table->state == State::kOpen) {
    if (added) agenda_.push_back({table, kNoConsumer});
    Subscribe(at, *table);
    return true;
  }
  if (added) {
    const std::size_t first = open_.size() - 1;
    const bool whole = step.call->recursive ? EvaluateComponent(run, *table) : Evaluate(run, *table);
    if (!whole) return false;
    CloseTables(first, State::kComplete);
  }
  if (table->state != State::kComplete) return Unfit(run);
  return TryRows(at, step, table->rows, table->origins.data(), values);
}

bool Tables::TryComputed(const Place& at, const TableStep& step, const Word* values) {
  std::array<Word, 32> goal = free_;
  for (const Operand& operand : step.operands) goal[operand.argument] = *values++;
  values -= step.operands.size();
  Computed* computed = shop_.oracles->Compute(step.predicate, {goal.data(), step.arity});
  if (computed == nullptr) return Unfit(*at.body->run);
  Place next = at;
  for (const std::size_t assumption : computed->assumptions) {
    next.resting = store_.arena.Make(Resting{next.resting, assumption});
  }
  if (step.positive) return TryRows(next, step, computed->rows, nullptr, values);
  for (std::uint32_t row = 0; row < computed->rows.rows(); ++row) {
    if (Agrees(step, values, computed->rows.row(row))) return true;
  }
  shop_.meter->CountInference();
  ++next.step;
  return Continue(next);
}

Tables::Outcome Tables::Close(Place& at, const TableStep& step) {
  if (!Count()) return Outcome::kEnds;
  std::array<Word, 32> values;
  const Arena::Mark mark = stack_.arena.mark();
  const bool made = MakeValues(step, at.body->slots, values.data());
  const Closing closing =
      made ? shop_.oracles->Close(step.predicate, {values.data(), step.arity}) : Closing{};
  stack_.arena.Release(mark);
  if (!made || closing.result == Closing::Result::kProved) return Outcome::kFails;
  if (closing.result == Closing::Result::kUndetermined) {
    at.body->run->unfit = true;
    return Outcome::kEnds;
  }
  at.resting = store_.arena.Make(Resting{at.resting, closing.assumption});
  return Outcome::kHolds;
}

Tables::Outcome Tables::Unify(const Body& body, const TableStep& step) {
  if (!Count()) return Outcome::kEnds;
  const Arena::Mark mark = store_.arena.mark();
  Word value = 0;
  Word other = 0;
  bool same = MakeValue(step.operands[0], body.slots, store_, value);
  if (same && step.operands.size() == 2) {
    same = MakeValue(step.operands[1], body.slots, store_, other) && AreSame(value, other);
  } else if (same) {
    same = Match(step.pattern, &value, body.slots);
  }
  if (!same) {
    store_.arena.Release(mark);
    return Outcome::kFails;
  }
  shop_.meter->CountInference();
  return Outcome::kHolds;
}

bool Tables::Deliver(const Place& at) {
  const Body& body = *at.body;
  if (body.target == nullptr) {
    const Proof proof{body.plan->rule, body.slots, at.resting, nullptr, at.depth};
    body.run->enough = body.run->sink->Accept(proof);
    return !body.run->enough;
  }
  Table& table = *body.target;
  std::array<Word, 32> row;
  std::copy_n(table.arguments, table.rows.arity(), row.data());
  const Arena::Mark mark = store_.arena.mark();
  for (const Operand& operand : body.plan->answer) {
    MakeValue(operand, body.slots, store_, row[operand.argument]);
  }
  if (!Enter(table, row.data(), {at.resting, at.depth + 1})) store_.arena.Release(mark);
  return !table.IsFull();
}

bool Tables::Evaluate(Run& run, Table& table) {
  const auto* plans = run.program->PlansFor(*table.call);
  if (plans == nullptr) return Unfit(run);
  EvaluateFacts(table);
  for (const TablePlan& plan : *plans) {
    if (!Count()) return false;
    if (table.IsFull()) break;
    const Arena::Mark mark = stack_.arena.mark();
    const bool go_on =
        EvaluateRule({&run, &plan, &table, stack_.arena.Allocate(plan.rule->slots)});
    stack_.arena.Release(mark);
    if (!go_on && (!table.IsFull() || HasEnded(run))) return false;
  }
  return true;
}

bool Tables::EvaluateRule(const Body& body) {
  if (!Match(body.plan->call, body.target->arguments, body.slots)) return true;
  shop_.meter->CountInference();
  return Continue({&body, 0, nullptr, 0});
}

void Tables::EvaluateFacts(Table& table) {
  const TableCall& call = *table.call;
  if ((call.key & 1U) == 0) return;
  const auto column = static_cast<std::size_t>(std::countr_zero(call.ground));
  for (const FactStore::Entry& entry : shop_.facts->Tables(call.key / 2)) {
    if (!entry.source->enabled) continue;
    auto cursor = call.ground == 0 ? entry.table->All()
                                   : entry.table->FindBy(column, table.arguments[column]);
    for (; cursor.row != kNoRow && Count(); FactTable::Advance(cursor)) {
      const Word* row = entry.table->row(cursor.row);
      bool same = true;
      for (std::uint64_t bits = call.ground; same && bits != 0; bits &= bits - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(bits));
        same = AreSame(table.arguments[i], row[i]);
      }
      if (!same) continue;
      shop_.meter->CountInference();
      Enter(table, row, {nullptr, 0});
      if (table.IsFull()) return;
    }
  }
}

bool Tables::EvaluateComponent(Run& run, Table& table) {
  const std::size_t base = agenda_.size();
  agenda_.push_back({&table, kNoConsumer});
  while (agenda_.size() > base) {
    const Task task = agenda_.back();
    agenda_.pop_back();
    const bool go_on =
        task.consumer == kNoConsumer ? Evaluate(run, *task.table) : Resume(task.consumer);
    if (go_on) continue;
    agenda_.resize(base);
    return false;
  }
  return true;
}

void Tables::Subscribe(const Place& at, Table& table) {
  const std::size_t count = at.body->plan->rule->slots;
  Body body = *at.body;
  body.slots = store_.arena.Allocate(count);
  std::copy_n(at.body->slots, count, body.slots);
  const auto number = static_cast<std::uint32_t>(consumers_.size());
  consumers_.push_back({body, at, &table, 0, true});
  table.consumers.push_back(number);
  agenda_.push_back({nullptr, number});
}

bool Tables::Resume(std::uint32_t number) {
  consumers_[number].queued = false;
  const Body body = consumers_[number].body;
  const Place at = consumers_[number].place;
  const Table& source = *consumers_[number].source;
  const TableStep& step = body.plan->steps[at.step];
  while (consumers_[number].next < source.rows.rows() && !body.target->IsFull()) {
    const std::uint32_t row = consumers_[number].next++;
    if (!Count()) return false;
    // The answers of a call agree with it.
    if (!Match(step.pattern, source.rows.row(row), body.slots)) continue;
    shop_.meter->CountInference();
    const Origin origin = source.origins[row];
    const bool go_on = Continue({&body, at.step + 1, Join(at.resting, origin.resting),
                                 std::max(at.depth, origin.depth)});
    if (!go_on && (!body.target->IsFull() || HasEnded(*body.run))) return false;
  }
  return true;
}

}  // namespace latchwork::pttp

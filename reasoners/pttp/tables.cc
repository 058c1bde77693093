// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tables.h"

#include <algorithm>
#include <utility>

namespace latchwork::pttp {
namespace {

constexpr std::size_t kMostWords = std::size_t{1} << 26U;
constexpr std::size_t kDeepestNesting = 4096;
constexpr std::uint32_t kNoConsumer = 0xffffffffU;

/// Holds or does not, and binds nothing.
bool IsTest(const TableStep& step) {
  return step.kind == TableStep::Kind::kArithmetic || step.kind == TableStep::Kind::kDiffer;
}

}  // namespace

Tables::Tables(const Workshop& shop)
    : shop_(shop),
      keeper_(store_),
      builder_(stack_),
      keeping_calculator_(*shop.functors, store_),
      calculator_(*shop.functors, stack_) {
  for (Word& word : free_) word = Reference(&word);
}

void Tables::Begin() {
  store_.Clear();
  stack_.Clear();
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
  const Arena::Mark mark = stack_.mark();
  Word* slots = MakeSlots(query.rule->slots);
  std::copy(given.begin(), given.end(), slots);
  const bool whole = Continue({&run, &query, nullptr, slots, nullptr, 0}, 0);
  stack_.Release(mark);
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

bool Tables::Count() {
  shop_.meter->CountWork();
  return !shop_.meter->stopped();
}

bool Tables::Continue(const Frame& frame, std::size_t step) {
  const std::vector<TableStep>& steps = frame.plan->steps;
  for (; step < steps.size() && IsTest(steps[step]); ++step) {
    const Arena::Mark mark = stack_.mark();
    if (!Count()) return false;
    const bool holds = Holds(frame, steps[step]);
    stack_.Release(mark);
    if (!holds) return true;
  }
  if (step == steps.size()) return Deliver(frame);
  if (nesting_ == kDeepestNesting) return Unfit(*frame.run);
  ++nesting_;
  const Arena::Mark mark = stack_.mark();
  bool go_on = true;
  switch (steps[step].kind) {
    case TableStep::Kind::kFacts:
      go_on = TryFacts(frame, step);
      break;
    case TableStep::Kind::kCall:
      go_on = TryCall(frame, step);
      break;
    case TableStep::Kind::kUnify:
      go_on = TryUnify(frame, step);
      break;
    case TableStep::Kind::kAttachment:
      go_on = TryComputed(frame, step);
      break;
    case TableStep::Kind::kClosing:
      go_on = TryClosing(frame, step);
      break;
    case TableStep::Kind::kArithmetic:
    case TableStep::Kind::kDiffer:
      break;  // done above
  }
  stack_.Release(mark);
  --nesting_;
  return go_on;
}

bool Tables::TryRow(const Frame& frame, std::size_t step, const Word* row, const Origin& origin,
                    const Word* goal) {
  if (!Count()) return false;
  if (!Matches(frame.plan->steps[step], row, goal, frame.slots)) return true;
  shop_.meter->CountInference();
  if (origin.resting == nullptr && origin.depth <= frame.depth) return Continue(frame, step + 1);
  Frame next = frame;
  next.resting = Join(frame.resting, origin.resting);
  next.depth = std::max(frame.depth, origin.depth);
  return Continue(next, step + 1);
}

bool Tables::TryRows(const Frame& frame, std::size_t step, FactTable& rows,
                     std::span<const Origin> origins, const Word* goal) {
  FactTable::Cursor cursor = rows.Find(goal);
  while (cursor.row != kNoRow) {
    const std::uint32_t row = cursor.row;
    FactTable::Advance(cursor);
    const Origin origin = origins.empty() ? Origin{nullptr, 0} : origins[row];
    if (!TryRow(frame, step, rows.row(row), origin, goal)) return false;
  }
  return true;
}

bool Tables::TryFacts(const Frame& frame, std::size_t step) {
  const TableStep& facts = frame.plan->steps[step];
  if (!facts.literal->positive) return true;
  const Word* goal = MakeGoal(facts, frame.slots);
  if (goal == nullptr) return true;
  for (const FactStore::Entry& entry : shop_.facts->Tables(facts.literal->predicate)) {
    if (!entry.source->enabled) continue;
    if (!TryRows(frame, step, *entry.table, {}, goal)) return false;
  }
  return true;
}

bool Tables::TryCall(const Frame& frame, std::size_t step) {
  const TableStep& call = frame.plan->steps[step];
  const Word* goal = MakeGoal(call, frame.slots);
  if (goal == nullptr) return true;
  bool added = false;
  Table* table = FindTable(*frame.run, call, goal, added);
  if (table == nullptr) return Unfit(*frame.run);
  if (call.recursive && table->state == State::kOpen) {
    if (added) agenda_.push_back({table, kNoConsumer});
    Subscribe(frame, step, *table);
    return true;
  }
  if (added) {
    const bool recursive = frame.run->program->IsRecursive(call.key);
    const std::size_t first = open_.size() - 1;
    const bool whole =
        recursive ? EvaluateComponent(*frame.run, *table) : Evaluate(*frame.run, *table);
    if (!whole) return false;
    CloseTables(first, State::kComplete);
  }
  if (table->state != State::kComplete) return Unfit(*frame.run);
  return TryRows(frame, step, table->rows, table->origins, goal);
}

Tables::Table* Tables::FindTable(Run& run, const TableStep& step, const Word* goal, bool& added) {
  const bool closing = run.program->reach().closing;
  const std::size_t label = 2 * std::size_t{step.key} + (closing ? 1 : 0);
  if (label < general_.size() && general_[label] != nullptr &&
      general_[label]->state == State::kComplete) {
    return general_[label];
  }
  std::uint64_t hash = label;
  for (std::uint32_t i = 0; i < step.literal->arity; ++i) {
    hash = MixHash(hash, ShallowHash(goal[i]));
  }
  const auto fresh = static_cast<std::uint32_t>(tables_.size());
  const std::uint32_t number = calls_.Enter(
      hash, fresh, [&](std::uint32_t known) { return IsCall(*tables_[known], step, label, goal); });
  added = number == fresh;
  return added ? MakeTable(step, label, goal) : tables_[number];
}

bool Tables::IsCall(const Table& table, const TableStep& step, std::size_t label,
                    const Word* goal) {
  if (table.label != label || table.ground != step.ground) return false;
  for (std::uint32_t i = 0; i < step.literal->arity; ++i) {
    if (((step.ground >> i) & 1U) != 0 && !AreSame(table.arguments[i], goal[i])) return false;
  }
  return true;
}

Tables::Table* Tables::MakeTable(const TableStep& step, std::size_t label, const Word* goal) {
  const std::uint32_t arity = step.literal->arity;
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
  table->ground = step.ground;
  table->key = step.key;
  table->label = label;
  table->number = static_cast<std::uint32_t>(tables_.size());
  table->state = State::kOpen;
  Word* arguments = store_.Allocate(arity);
  for (std::uint32_t i = 0; i < arity; ++i) {
    arguments[i] = ((step.ground >> i) & 1U) != 0 ? Keep(goal[i]) : goal[i];
  }
  table->arguments = arguments;
  tables_.push_back(table);
  open_.push_back(table);
  if (table->ground == 0) {
    if (label >= general_.size()) general_.resize(label + 1, nullptr);
    general_[label] = table;
  }
  return table;
}

void Tables::CloseTables(std::size_t first, State state) {
  for (std::size_t i = first; i < open_.size(); ++i) open_[i]->state = state;
  open_.resize(std::min(first, open_.size()));
}

bool Tables::Evaluate(Run& run, Table& table) {
  const auto* plans = run.program->PlansFor(table.key, table.ground);
  if (plans == nullptr) return Unfit(run);
  if (!EvaluateFacts(table)) return false;
  for (const TablePlan& plan : *plans) {
    if (!Count()) return false;
    const Contrapositive& rule = *plan.rule;
    const Arena::Mark mark = stack_.mark();
    Word* slots = MakeSlots(rule.slots);
    bool fits = true;
    for (std::uint32_t i = 0; fits && i < rule.head.arity; ++i) {
      fits = ((table.ground >> i) & 1U) == 0 ||
             Match(rule.head.arguments[i], table.arguments[i], slots);
    }
    if (fits) shop_.meter->CountInference();
    const bool go_on = !fits || Continue({&run, &plan, &table, slots, nullptr, 0}, 0);
    stack_.Release(mark);
    if (!go_on) return false;
  }
  return true;
}

bool Tables::EvaluateFacts(Table& table) {
  if ((table.key & 1U) == 0) return true;
  for (const FactStore::Entry& entry : shop_.facts->Tables(table.key / 2)) {
    if (!entry.source->enabled) continue;
    for (auto cursor = entry.table->Find(table.arguments); cursor.row != kNoRow;
         FactTable::Advance(cursor)) {
      const Word* row = entry.table->row(cursor.row);
      if (!Count()) return false;
      bool same = true;
      for (std::uint32_t i = 0; same && ((table.ground >> i) != 0); ++i) {
        same = ((table.ground >> i) & 1U) == 0 || AreSame(table.arguments[i], row[i]);
      }
      if (!same) continue;
      shop_.meter->CountInference();
      Enter(table, row, {nullptr, 0});
    }
  }
  return true;
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

void Tables::Subscribe(const Frame& frame, std::size_t step, Table& table) {
  const std::size_t count = frame.plan->rule->slots;
  Frame kept = frame;
  kept.slots = store_.Allocate(count);
  for (std::size_t i = 0; i < count; ++i) {
    const bool unbound = frame.slots[i] == Reference(frame.slots + i);
    kept.slots[i] = unbound ? Reference(kept.slots + i) : frame.slots[i];
  }
  const auto number = static_cast<std::uint32_t>(consumers_.size());
  consumers_.push_back({kept, step, &table, 0, true});
  table.consumers.push_back(number);
  agenda_.push_back({nullptr, number});
}

bool Tables::Resume(std::uint32_t number) {
  consumers_[number].queued = false;
  const Frame frame = consumers_[number].frame;
  const std::size_t step = consumers_[number].step;
  const Table& source = *consumers_[number].source;
  while (consumers_[number].next < source.rows.rows()) {
    const std::uint32_t row = consumers_[number].next++;
    const Arena::Mark mark = stack_.mark();
    const Word* goal = MakeGoal(frame.plan->steps[step], frame.slots);
    const bool go_on =
        goal == nullptr || TryRow(frame, step, source.rows.row(row), source.origins[row], goal);
    stack_.Release(mark);
    if (!go_on) return false;
  }
  return true;
}

bool Tables::Deliver(const Frame& frame) {
  if (frame.target == nullptr) {
    const Proof proof{frame.plan->rule, frame.slots, frame.resting, nullptr, frame.depth};
    frame.run->enough = frame.run->sink->Accept(proof);
    return !frame.run->enough;
  }
  const CompiledLiteral& head = frame.plan->rule->head;
  const Arena::Mark mark = store_.mark();
  Word* row = stack_.Allocate(head.arity);
  for (std::uint32_t i = 0; i < head.arity; ++i) {
    row[i] = BuildGround(head.arguments[i], frame.slots, keeper_);
  }
  if (!Enter(*frame.target, row, {frame.resting, frame.depth + 1})) store_.Release(mark);
  return true;
}

bool Tables::Enter(Table& table, const Word* row, const Origin& origin) {
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
  if (store_.reserved_words() + 8 * all_answers_.size() > kMostWords) {
    shop_.meter->Stop(sdk::Limit::kInferences);
  }
  std::copy_n(row, arity, table.rows.AddRow());
  table.origins.push_back(origin);
  for (const std::uint32_t consumer : table.consumers) {
    if (std::exchange(consumers_[consumer].queued, true)) continue;
    agenda_.push_back({nullptr, consumer});
  }
  return true;
}

}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tables/tables.h"

#include <algorithm>
#include <array>
#include <new>

namespace latchwork::pttp {
namespace {

constexpr std::size_t kDeepestNesting = 4096;

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
  Binding* binding = MakeBinding(*query.rule, stack_.arena);
  for (std::size_t i = 0; i < given.size(); ++i) binding->slots()[i] = Keep(given[i]);
  const bool whole = Proceed({&run, &query, nullptr}, 0, {&binding, 1});
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

/// Solves the rest of a body in every way, step by step for the whole batch, but for steps that may
/// ask for proofs: those see one binding after the other, each with all that follows from it.
bool Tables::Proceed(const Body& body, std::size_t step, Batch batch) {
  const std::vector<TableStep>& steps = body.plan->steps;
  for (; batch.count > 0 && step < steps.size(); ++step) {
    switch (steps[step].kind) {
      case TableStep::Kind::kArithmetic:
      case TableStep::Kind::kDiffer:
      case TableStep::Kind::kUnify:
        if (!Filter(steps[step], batch)) return false;
        break;
      case TableStep::Kind::kClosing:
        return OneByOne(body, step, batch);
      case TableStep::Kind::kAttachment:
        return steps[step].positive ? Join(body, step, batch) : OneByOne(body, step, batch);
      case TableStep::Kind::kFacts:
        if (!steps[step].positive) return true;
        [[fallthrough]];
      case TableStep::Kind::kCall: {
        const Origin* origins = nullptr;
        FactTable* rows = FindLookup(steps[step], origins);
        if (rows == nullptr) return Join(body, step, batch);
        if (!Lookup(steps[step], *rows, origins, batch)) return false;
      }
    }
  }
  return batch.count == 0 || Deliver(body, batch);
}

/// Keeps the bindings for which a step without choices holds.
bool Tables::Filter(const TableStep& step, Batch& batch) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < batch.count; ++i) {
    if (!Count()) return false;
    Binding* binding = batch.bindings[i];
    Word* slots = binding->slots();
    const bool holds = step.kind == TableStep::Kind::kArithmetic ? Compare(step, slots)
                       : step.kind == TableStep::Kind::kUnify    ? Unify(step, slots)
                                                                 : Differ(step, slots);
    if (holds) batch.bindings[kept++] = binding;
  }
  batch.count = kept;
  return true;
}

bool Tables::Unify(const TableStep& step, Word* slots) {
  const Arena::Mark mark = store_.arena.mark();
  Word value = 0;
  Word other = 0;
  bool same = MakeValue(step.operands[0], slots, store_, value);
  if (same && step.operands.size() == 2) {
    same = MakeValue(step.operands[1], slots, store_, other) && AreSame(value, other);
  } else if (same) {
    same = Match(step.pattern, &value, slots);
  }
  if (same) {
    shop_.meter->CountInference();
  } else {
    store_.arena.Release(mark);
  }
  return same;
}

/// Extends every binding by every row that agrees with it.
bool Tables::Join(const Body& body, std::size_t step, const Batch& batch) {
  if (nesting_ == kDeepestNesting) return Unfit(*body.run);
  ++nesting_;
  const Arena::Mark mark = stack_.arena.mark();
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): written before it is read
  std::array<Binding*, Batch::kMost> places;
  Output output{&body, step + 1, {places.data(), 0}, mark};
  bool go_on = true;
  for (std::size_t i = 0; go_on && i < batch.count; ++i) {
    go_on = Extend(body.plan->steps[step], *batch.bindings[i], output);
  }
  go_on = go_on && Flush(output);
  stack_.arena.Release(mark);
  --nesting_;
  return go_on;
}

/// The source's that alone has some; null when there are none or several.
FactTable* Tables::OnlyFacts(PredicateId predicate) const {
  FactTable* only = nullptr;
  for (const FactStore::Entry& entry : shop_.facts->Tables(predicate)) {
    if (!entry.source->enabled || entry.table->rows() == 0) continue;
    if (only != nullptr) return nullptr;
    only = entry.table;
  }
  return only;
}

FactTable* Tables::FindLookup(const TableStep& step, const Origin*& origins) {
  FactTable* rows = nullptr;
  if (step.kind == TableStep::Kind::kFacts) {
    rows = OnlyFacts(step.predicate);
  } else if (Table* general = GeneralTable(step); general != nullptr) {
    rows = &general->rows;
    origins = general->origins.data();
  }
  if (rows == nullptr) return nullptr;
  const bool single =
      step.operands.empty() ? rows->rows() <= 1 : rows->TellsRowsApart(step.operands[0].argument);
  return single ? rows : nullptr;
}

/// Extends every binding where it stands; keeps those for which there is a row.
bool Tables::Lookup(const TableStep& step, FactTable& rows, const Origin* origins, Batch& batch) {
  std::size_t kept = 0;
  const std::size_t count = step.wants_another_row ? 0 : batch.count;
  for (std::size_t i = 0; i < count; ++i) {
    if (!Count()) return false;
    Binding* binding = batch.bindings[i];
    const Arena::Mark mark = stack_.arena.mark();
    if (LookupRow(step, rows, origins, *binding)) batch.bindings[kept++] = binding;
    stack_.arena.Release(mark);
  }
  batch.count = kept;
  return true;
}

bool Tables::LookupRow(const TableStep& step, FactTable& rows, const Origin* origins,
                       Binding& binding) {
  const Word* values = ValuesOf(step, binding.slots());
  if (values == nullptr) return false;
  auto cursor =
      step.operands.empty() ? rows.All() : rows.FindBy(step.operands[0].argument, values[0]);
  for (; cursor.row != kNoRow; FactTable::Advance(cursor)) {
    const Word* row = rows.row(cursor.row);
    if (!Agrees(step, values, row)) continue;
    if (!Match(step.pattern, row, binding.slots())) return false;
    if (origins != nullptr) Inherit(origins[cursor.row], binding);
    shop_.meter->CountInference();
    return true;
  }
  return false;
}

bool Tables::Flush(Output& output) {
  if (output.batch.count == 0) return true;
  const bool go_on = Proceed(*output.body, output.step, output.batch);
  output.batch.count = 0;
  stack_.arena.Release(output.mark);
  return go_on;
}

bool Tables::Extend(const TableStep& step, Binding& binding, Output& output) {
  const Word* values = ValuesOf(step, binding.slots());
  if (values == nullptr) return true;
  output.mark = stack_.arena.mark();
  if (step.kind == TableStep::Kind::kCall) return ExtendByCall(step, values, binding, output);
  if (step.kind == TableStep::Kind::kFacts) return ExtendByFacts(step, values, binding, output);
  return ExtendByComputed(step, values, binding, output);
}

bool Tables::ExtendByFacts(const TableStep& step, const Word* values, Binding& binding,
                           Output& output) {
  const auto sources = shop_.facts->Tables(step.predicate);
  for (const FactStore::Entry& entry : sources) {
    if (!entry.source->enabled) continue;
    const bool last = &entry == &sources.back();
    if (!ExtendByRows(step, values, *entry.table, nullptr, last, binding, output)) return false;
  }
  return true;
}

bool Tables::ExtendByRows(const TableStep& step, const Word* values, FactTable& rows,
                          const Origin* origins, bool last, Binding& binding, Output& output) {
  const Contrapositive& rule = *output.body->plan->rule;
  Meter& meter = *shop_.meter;
  const bool binds = !step.pattern.steps.empty();
  auto cursor =
      step.operands.empty() ? rows.All() : rows.FindBy(step.operands.front().argument, values[0]);
  while (cursor.row != kNoRow) {
    meter.CountWork();
    if (meter.stopped()) return false;
    const std::uint32_t number = cursor.row;
    const Word* row = rows.row(number);
    FactTable::Advance(cursor);
    if (!Agrees(step, values, row)) continue;
    const bool in_place = last && (cursor.row == kNoRow || !binds);
    const Arena::Mark mark = stack_.arena.mark();
    Binding* extended = in_place ? &binding : CopyOf(rule, binding, stack_.arena);
    if (!Match(step.pattern, row, extended->slots())) {
      stack_.arena.Release(mark);
      continue;
    }
    meter.CountInference();
    if (origins != nullptr) Inherit(origins[number], *extended);
    output.batch.bindings[output.batch.count++] = extended;
    if (output.batch.count == Batch::kMost && !Flush(output)) return false;
    if (!binds) break;  // other rows that agree are the same
  }
  return true;
}

bool Tables::Deliver(const Body& body, const Batch& batch) {
  for (std::size_t i = 0; i < batch.count; ++i) {
    Binding& binding = *batch.bindings[i];
    if (body.target != nullptr) {
      if (!DeliverAnswer(body, binding)) return false;
      continue;
    }
    const auto depth = static_cast<std::uint32_t>(binding.depth);
    const Proof proof{body.plan->rule, binding.slots(), binding.resting, nullptr, depth};
    body.run->enough = body.run->sink->Accept(proof);
    if (body.run->enough) return false;
  }
  return true;
}

bool Tables::DeliverAnswer(const Body& body, Binding& binding) {
  Table& table = *body.target;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): written before it is read
  std::array<Word, kMostArguments> row;
  std::copy_n(table.arguments, table.rows.arity(), row.data());
  const Arena::Mark mark = store_.arena.mark();
  for (const Operand& operand : body.plan->answer) {
    MakeValue(operand, binding.slots(), store_, row[operand.argument]);
  }
  const Origin origin{binding.resting, static_cast<std::uint32_t>(binding.depth + 1)};
  if (!AddAnswer(table, row.data(), origin)) store_.arena.Release(mark);
  return !table.IsFull();
}

}  // namespace latchwork::pttp

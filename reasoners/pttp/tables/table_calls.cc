// SPDX-License-Identifier: BSD-3-Clause
// The part of the tables that evaluates calls, and asks the oracles.
#include <algorithm>
#include <array>
#include <bit>

#include "reasoners/pttp/tables/tables.h"

namespace latchwork::pttp {
namespace {

constexpr std::uint32_t kNoConsumer = 0xffffffffU;

}  // namespace

bool Tables::ExtendByCall(const TableStep& step, const Word* values, Binding& binding,
                          Output& output) {
  if (Table* general = GeneralTable(step); general != nullptr) {
    return ExtendByRows(step, values, general->rows, general->origins.data(), true, binding,
                        output);
  }
  // What the bindings before lead to comes first: it may ask for proofs as well.
  if (!Flush(output)) return false;
  Run& run = *output.body->run;
  bool added = false;
  Table* table = FindTable(step, values, added);
  if (step.recursive && table->state == State::kOpen) {
    if (added) agenda_.push_back({table, kNoConsumer});
    Subscribe(*output.body, output.step - 1, binding, *table);
    return true;
  }
  if (added && !Complete(run, *table)) return false;
  if (table->state != State::kComplete) return Unfit(run);
  return ExtendByRows(step, values, table->rows, table->origins.data(), true, binding, output);
}

bool Tables::Complete(Run& run, Table& table) {
  const std::size_t first = open_.size() - 1;
  const bool whole = table.call->recursive ? EvaluateComponent(run, table) : Evaluate(run, table);
  if (whole) CloseTables(first, State::kComplete);
  return whole;
}

bool Tables::ExtendByComputed(const TableStep& step, const Word* values, Binding& binding,
                              Output& output) {
  if (!Flush(output)) return false;
  Computed* computed = Compute(step, values, binding);
  if (computed == nullptr) return Unfit(*output.body->run);
  return ExtendByRows(step, values, computed->rows, nullptr, true, binding, output);
}

/// Null when it cannot be had.
Computed* Tables::Compute(const TableStep& step, const Word* values, Binding& binding) {
  std::array<Word, kMostArguments> goal = free_;
  for (const Operand& operand : step.operands) goal[operand.argument] = *values++;
  Computed* computed = shop_.oracles->Compute(step.predicate, {goal.data(), step.arity});
  if (computed == nullptr) return nullptr;
  for (const std::size_t assumption : computed->assumptions) {
    binding.resting = store_.arena.Make(Resting{binding.resting, assumption});
  }
  return computed;
}

bool Tables::OneByOne(const Body& body, std::size_t step, const Batch& batch) {
  const TableStep& asks = body.plan->steps[step];
  for (std::size_t i = 0; i < batch.count; ++i) {
    if (!Count()) return false;
    Binding& binding = *batch.bindings[i];
    const Outcome outcome = asks.kind == TableStep::Kind::kClosing ? Close(body, asks, binding)
                                                                   : Deny(body, asks, binding);
    if (outcome == Outcome::kEnds) return false;
    if (outcome == Outcome::kFails) continue;
    if (!Proceed(body, step + 1, {batch.bindings + i, 1})) return false;
  }
  return true;
}

Tables::Outcome Tables::Close(const Body& body, const TableStep& step, Binding& binding) {
  const Arena::Mark mark = stack_.arena.mark();
  const Word* values = ValuesOf(step, binding.slots());
  Closing closing{Closing::Result::kProved, 0};
  if (values != nullptr) closing = shop_.oracles->Close(step.predicate, {values, step.arity});
  stack_.arena.Release(mark);
  if (closing.result == Closing::Result::kProved) return Outcome::kFails;
  if (closing.result == Closing::Result::kUndetermined) {
    Unfit(*body.run);
    return Outcome::kEnds;
  }
  binding.resting = store_.arena.Make(Resting{binding.resting, closing.assumption});
  return Outcome::kHolds;
}

/// The denial of an attachment.
Tables::Outcome Tables::Deny(const Body& body, const TableStep& step, Binding& binding) {
  const Arena::Mark mark = stack_.arena.mark();
  const Word* values = ValuesOf(step, binding.slots());
  Outcome outcome = Outcome::kFails;
  if (values != nullptr) {
    const Computed* computed = Compute(step, values, binding);
    outcome = computed == nullptr ? Outcome::kEnds : Outcome::kHolds;
    if (computed == nullptr) Unfit(*body.run);
    for (std::uint32_t row = 0; outcome == Outcome::kHolds && row < computed->rows.rows(); ++row) {
      if (Agrees(step, values, computed->rows.row(row))) outcome = Outcome::kFails;
    }
  }
  if (outcome == Outcome::kHolds) shop_.meter->CountInference();
  stack_.arena.Release(mark);
  return outcome;
}

bool Tables::Evaluate(Run& run, Table& table) {
  const auto* plans = run.program->PlansFor(*table.call);
  if (plans == nullptr) return Unfit(run);
  EvaluateFacts(table);
  for (const TablePlan& plan : *plans) {
    if (!Count()) return false;
    if (table.IsFull()) break;
    const Arena::Mark mark = stack_.arena.mark();
    const bool go_on = EvaluateRule({&run, &plan, &table});
    stack_.arena.Release(mark);
    if (!go_on && (!table.IsFull() || HasEnded(run))) return false;
  }
  return true;
}

bool Tables::EvaluateRule(const Body& body) {
  Binding* binding = MakeBinding(*body.plan->rule, stack_.arena);
  if (!Match(body.plan->call, body.target->arguments, binding->slots())) return true;
  shop_.meter->CountInference();
  return Proceed(body, 0, {&binding, 1});
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
      AddAnswer(table, row, {nullptr, 0});
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

void Tables::Subscribe(const Body& body, std::size_t step, Binding& binding, Table& table) {
  Binding* kept = CopyOf(*body.plan->rule, binding, store_.arena);
  const auto number = static_cast<std::uint32_t>(consumers_.size());
  consumers_.push_back({body, step, kept, &table, 0, true});
  table.consumers.push_back(number);
  agenda_.push_back({nullptr, number});
}

bool Tables::Resume(std::uint32_t number) {
  consumers_[number].queued = false;
  const Body body = consumers_[number].body;
  const Arena::Mark mark = stack_.arena.mark();
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): written before it is read
  std::array<Binding*, Batch::kMost> places;
  Output output{&body, consumers_[number].step + 1, {places.data(), 0}, mark};
  bool go_on = true;
  do {
    go_on = Flush(output) && TakeAnswers(number, output);
  } while (go_on && output.batch.count > 0);
  stack_.arena.Release(mark);
  return go_on || (body.target->IsFull() && !HasEnded(*body.run));
}

/// Extends a consumer's binding by answers that it has not seen, as many as there is room for.
bool Tables::TakeAnswers(std::uint32_t number, Output& output) {
  Consumer& consumer = consumers_[number];
  const TableStep& step = consumer.body.plan->steps[consumer.step];
  const Table& source = *consumer.source;
  while (consumer.next < source.rows.rows() && output.batch.count < Batch::kMost) {
    if (!Count()) return false;
    const std::uint32_t row = consumer.next++;
    const Arena::Mark mark = stack_.arena.mark();
    Binding* extended = CopyOf(*consumer.body.plan->rule, *consumer.binding, stack_.arena);
    // The answers of a call agree with it.
    if (!Match(step.pattern, source.rows.row(row), extended->slots())) {
      stack_.arena.Release(mark);
      continue;
    }
    shop_.meter->CountInference();
    Inherit(source.origins[row], *extended);
    output.batch.bindings[output.batch.count++] = extended;
  }
  return true;
}

}  // namespace latchwork::pttp

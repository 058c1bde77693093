// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "reasoners/circumscription/evaluation/evaluator.h"

namespace latchwork::circumscription {

void Evaluator::Start(const Rule& rule, std::size_t newest) {
  const Frame frame{&rule, bindings_.size(), trail_.size(), newest};
  bindings_.resize(frame.base + rule.variables);
  Continue(frame, 0);
  bindings_.resize(frame.base);
}

void Evaluator::Continue(const Frame& frame, std::size_t step) {
  if (stops()) return;
  if (step == frame.rule->steps.size()) return Fire(frame);
  const Step& next = frame.rule->steps[step];
  switch (next.kind) {
    case Step::Kind::kJoin:
      return Join(frame, step);
    case Step::Kind::kAbsent:
      return CheckAbsent(frame, step);
    case Step::Kind::kCall:
      return CallAttachment(frame, step);
    case Step::Kind::kTest:
    case Step::Kind::kEqual:
      if (Holds(next, frame.base)) Continue(frame, step + 1);
  }
}

void Evaluator::Join(const Frame& frame, std::size_t step) {
  const Step& join = frame.rule->steps[step];
  const FactTable& table = *tables_[join.relation];
  std::uint32_t begin = 0;
  std::uint32_t end = table.size();
  if (join.ordinal != kNoIndex) {
    const Window& window = windows_[join.relation];
    begin = join.ordinal == frame.newest ? window.old : 0;
    end = join.ordinal < frame.newest ? window.old : window.end;
  }
  Value key;
  if (join.lookup == kNoIndex) {
    for (std::uint32_t row = begin; row < end; ++row) Visit(frame, step, row);
  } else if (Build(join.arguments[join.lookup], frame.base, key)) {
    std::uint32_t row = table.First(join.lookup, key);
    for (; row < end; row = table.Next(join.lookup, row)) {
      if (row >= begin) Visit(frame, step, row);
    }
  }
}

void Evaluator::Visit(const Frame& frame, std::size_t step, std::uint32_t row) {
  if (stops()) return;
  spending_.Infer();
  const Step& join = frame.rule->steps[step];
  for (std::size_t i = 0; i < join.arguments.size(); ++i) {
    if (!Match(join.arguments[i], tables_[join.relation]->Row(row)[i], frame.base)) return;
  }
  trail_.push_back({static_cast<std::uint32_t>(join.relation), row});
  Continue(frame, step + 1);
  trail_.pop_back();
}

void Evaluator::CheckAbsent(const Frame& frame, std::size_t step) {
  const Step& absent = frame.rule->steps[step];
  if (!BuildCells(absent.arguments, frame.base)) return;
  const std::uint32_t contrary = tables_[absent.relation]->Find(cells_);
  const std::uint32_t asked = AskDefault(absent.relation, contrary);
  // In grounding, a fact is one that may hold: whether its contrary is certain is asked later.
  if (contrary != FactTable::kNone && sink_ == nullptr) return;
  trail_.push_back({FactRef::kAssumption, asked});
  Continue(frame, step + 1);
  trail_.pop_back();
}

bool Evaluator::Holds(const Step& step, std::size_t base) {
  std::array<Value, 2> values;
  const std::size_t count = step.kind == Step::Kind::kEqual ? 1 : step.arguments.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!Build(step.arguments[i], base, values.at(i))) return false;
  }
  if (step.kind == Step::Kind::kEqual) {
    return Match(step.arguments[1], values[0], base) != step.negated;
  }
  std::array<logic::Term, 2> terms;
  for (std::size_t i = 0; i < count; ++i) terms.at(i) = bank_.ToTerm(values.at(i));
  const auto holds =
      logic::Arithmetic::Evaluate(step.test, std::span<const logic::Term>(terms.data(), count));
  return holds && *holds != step.negated;
}

bool Evaluator::Match(const Pattern& pattern, const Value& value, std::size_t base) {
  switch (pattern.kind) {
    case Pattern::Kind::kValue:
      return pattern.value == value;
    case Pattern::Kind::kBind:
      bindings_[base + pattern.variable] = value;
      return true;
    case Pattern::Kind::kRead:
      return bindings_[base + pattern.variable] == value;
    case Pattern::Kind::kCompute: {
      Value computed;
      return Compute(pattern, base, computed) && computed == value;
    }
    case Pattern::Kind::kCompound:
      break;
  }
  if (value.kind != Value::Kind::kCompound || bank_.Function(value) != pattern.function ||
      bank_.Arguments(value).size() != pattern.arguments.size()) {
    return false;
  }
  for (std::size_t i = 0; i < pattern.arguments.size(); ++i) {
    if (!Match(pattern.arguments[i], bank_.Arguments(value)[i], base)) return false;
  }
  return true;
}

bool Evaluator::Build(const Pattern& pattern, std::size_t base, Value& value) {
  switch (pattern.kind) {
    case Pattern::Kind::kValue:
      value = pattern.value;
      return true;
    case Pattern::Kind::kBind:
    case Pattern::Kind::kRead:
      value = bindings_[base + pattern.variable];
      return true;
    case Pattern::Kind::kCompute:
      return Compute(pattern, base, value);
    case Pattern::Kind::kCompound:
      break;
  }
  const std::size_t first = arguments_.size();
  for (const Pattern& argument : pattern.arguments) {
    Value built;
    if (!Build(argument, base, built)) {
      arguments_.resize(first);
      return false;
    }
    arguments_.push_back(built);
  }
  value = bank_.Compound(pattern.function, std::span(arguments_).subspan(first));
  arguments_.resize(first);
  return true;
}

bool Evaluator::Compute(const Pattern& pattern, std::size_t base, Value& value) {
  std::array<logic::Term, 2> terms;
  const std::size_t count = pattern.arguments.size();
  for (std::size_t i = 0; i < count; ++i) {
    Value argument;
    if (!Build(pattern.arguments[i], base, argument) || !argument.is_number()) return false;
    terms.at(i) = bank_.ToTerm(argument);
  }
  const auto result = logic::Arithmetic::Evaluate(
      pattern.compute, std::span<const logic::Term>(terms.data(), count));
  if (result) value = bank_.Of(*result);
  return result.has_value();
}

bool Evaluator::BuildCells(std::span<const Pattern> patterns, std::size_t base) {
  cells_.clear();
  for (const Pattern& pattern : patterns) {
    Value value;
    if (!Build(pattern, base, value)) return false;
    cells_.push_back(value);
  }
  return true;
}

}  // namespace latchwork::circumscription

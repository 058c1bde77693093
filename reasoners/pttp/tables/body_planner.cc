// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tables/body_planner.h"

#include <algorithm>

namespace latchwork::pttp {

bool BodyPlanner::Plan(std::uint32_t component, std::vector<TableStep>& steps) {
  left_.clear();
  for (std::size_t i = 0; i < rule_.body.size(); ++i) left_.push_back(i);
  while (!left_.empty()) {
    const auto chosen = Choose();
    if (chosen == left_.end()) return false;
    steps.push_back(MakeStep(rule_.body[*chosen], component));
    left_.erase(chosen);
  }
  NoteDistinctRows(steps);
  return !code_.failed();
}

namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

bool IsTaken(const TableStep& step) {
  return step.positive &&
         (step.kind == TableStep::Kind::kFacts || step.kind == TableStep::Kind::kCall);
}

/// At which argument a step gives a slot its value.
std::uint32_t PlaceOf(const TableStep& step, std::uint32_t slot) {
  for (const MatchStep& match : step.pattern.steps) {
    if (match.kind != MatchStep::Kind::kBind || match.of_part || match.slot != slot) continue;
    return match.source;
  }
  return kNone;
}

/// Whether the row that the earlier step took agrees with an operand of a later one.
bool Agrees(const TableStep& earlier, const Operand& operand) {
  if (operand.kind == Operand::Kind::kSlot && PlaceOf(earlier, operand.slot) == operand.argument) {
    return true;
  }
  return std::any_of(earlier.operands.begin(), earlier.operands.end(), [&](const Operand& known) {
    return known.argument == operand.argument && known.kind == operand.kind && !known.is_fresh() &&
           known.slot == operand.slot && known.word == operand.word;
  });
}

/// A comparison that fails for equal values.
bool IsStrict(const TableStep& step) {
  using Predicate = logic::Arithmetic::Predicate;
  if (step.kind == TableStep::Kind::kDiffer) return true;
  if (step.kind != TableStep::Kind::kArithmetic) return false;
  const bool strict = step.comparison == Predicate::kLess || step.comparison == Predicate::kGreater;
  const bool weak =
      step.comparison == Predicate::kLessEq || step.comparison == Predicate::kGreaterEq;
  return step.positive ? strict : weak;
}

/// Whether a step sets two rows apart by values at the same argument.
bool SetsApart(const TableStep& step, const TableStep& earlier, const TableStep& later) {
  if (!IsStrict(step) || step.operands.size() != 2) return false;
  const Operand& a = step.operands[0];
  const Operand& b = step.operands[1];
  if (a.kind != Operand::Kind::kSlot || b.kind != Operand::Kind::kSlot) return false;
  const auto meet = [&](std::uint32_t first, std::uint32_t second) {
    return PlaceOf(earlier, first) != kNone && PlaceOf(earlier, first) == PlaceOf(later, second);
  };
  return meet(a.slot, b.slot) || meet(b.slot, a.slot);
}

bool WantsAnotherRow(const std::vector<TableStep>& steps, const TableStep& earlier,
                     const TableStep& later) {
  return IsTaken(earlier) && earlier.kind == later.kind && earlier.predicate == later.predicate &&
         std::all_of(later.operands.begin(), later.operands.end(),
                     [&](const Operand& operand) { return Agrees(earlier, operand); }) &&
         std::any_of(steps.begin(), steps.end(),
                     [&](const TableStep& step) { return SetsApart(step, earlier, later); });
}

}  // namespace

void BodyPlanner::NoteDistinctRows(std::vector<TableStep>& steps) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!IsTaken(steps[i]) || steps[i].recursive || steps[i].operands.empty()) continue;
    for (std::size_t j = 0; j < i && !steps[i].wants_another_row; ++j) {
      steps[i].wants_another_row = WantsAnotherRow(steps, steps[j], steps[i]);
    }
  }
}

bool BodyPlanner::HasRules(const CompiledLiteral& literal) const {
  return !program_.reach().RulesFor(Signed(literal.predicate, literal.positive)).empty();
}

PredicateKind BodyPlanner::KindOf(const CompiledLiteral& literal) const {
  return (*program_.predicates_)[literal.predicate].kind;
}

bool BodyPlanner::IsReady(const CompiledLiteral& literal) const {
  const bool whole = !literal.positive &&
                     (program_.IsClosing(literal) || KindOf(literal) == PredicateKind::kEquality);
  for (std::uint32_t i = 0; i < literal.arity; ++i) {
    const bool needed = whole || ((literal.needs_ground >> i) & 1U) != 0;
    if (needed && !code_.IsBound(literal.arguments[i])) return false;
  }
  if (KindOf(literal) != PredicateKind::kEquality) return true;
  return HasBoundArgument(literal);
}

bool BodyPlanner::HasBoundArgument(const CompiledLiteral& literal) const {
  return std::any_of(literal.arguments, literal.arguments + literal.arity,
                     [&](Word word) { return code_.IsBound(word); });
}

template <typename Wanted>
BodyPlanner::Place BodyPlanner::First(Wanted&& wanted) {
  return std::find_if(left_.begin(), left_.end(), [&](std::size_t index) {
    const CompiledLiteral& literal = rule_.body[index];
    return IsReady(literal) && wanted(literal);
  });
}

BodyPlanner::Place BodyPlanner::Choose() {
  const auto computed = First([&](const CompiledLiteral& literal) {
    const PredicateKind kind = KindOf(literal);
    return kind == PredicateKind::kArithmetic || kind == PredicateKind::kEquality;
  });
  if (computed != left_.end()) return computed;
  const auto first = First([](const CompiledLiteral&) { return true; });
  if (first == left_.end() || !program_.reorder_ || !HasRules(rule_.body[*first])) return first;
  const auto extensional = First([&](const CompiledLiteral& literal) {
    return literal.positive && literal.needs_ground == 0 && !HasRules(literal) &&
           KindOf(literal) == PredicateKind::kOrdinary && HasBoundArgument(literal);
  });
  return extensional != left_.end() ? extensional : first;
}

TableStep::Kind BodyPlanner::StepKind(const CompiledLiteral& literal) const {
  switch (KindOf(literal)) {
    case PredicateKind::kArithmetic:
      return TableStep::Kind::kArithmetic;
    case PredicateKind::kEquality:
      return literal.positive ? TableStep::Kind::kUnify : TableStep::Kind::kDiffer;
    case PredicateKind::kAttachment:
      return TableStep::Kind::kAttachment;
    case PredicateKind::kOrdinary:
      break;
  }
  if (program_.IsClosing(literal)) return TableStep::Kind::kClosing;
  return HasRules(literal) ? TableStep::Kind::kCall : TableStep::Kind::kFacts;
}

TableStep BodyPlanner::MakeStep(const CompiledLiteral& literal, std::uint32_t component) {
  TableStep step;
  step.kind = StepKind(literal);
  step.positive = literal.positive;
  step.comparison = (*program_.predicates_)[literal.predicate].arithmetic;
  step.predicate = literal.predicate;
  step.arity = literal.arity;
  MakeCode(literal, step);
  if (step.kind != TableStep::Kind::kCall) return step;
  const std::uint32_t key = Signed(literal.predicate, literal.positive);
  std::uint64_t ground = 0;
  for (const Operand& operand : step.operands) ground |= std::uint64_t{1} << operand.argument;
  step.call = &program_.CallOf(key, literal.arity, ground);
  step.recursive = step.call->recursive && program_.components_[key].number == component;
  return step;
}

void BodyPlanner::MakeCode(const CompiledLiteral& literal, TableStep& step) {
  std::vector<std::uint32_t> open;
  for (std::uint32_t i = 0; i < literal.arity; ++i) {
    if (!code_.IsBound(literal.arguments[i])) {
      open.push_back(i);
      continue;
    }
    const bool computed = ((literal.arithmetic >> i) & 1U) != 0;
    step.operands.push_back(code_.MakeOperand(literal.arguments[i], i, computed));
  }
  const bool equation = step.kind == TableStep::Kind::kUnify;
  for (const std::uint32_t i : open) {
    code_.AddMatch(literal.arguments[i], equation ? 0 : i, step.pattern);
  }
}

}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/body_planner.h"

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
  return !code_.failed();
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
  const Place computed = First([&](const CompiledLiteral& literal) {
    const PredicateKind kind = KindOf(literal);
    return kind == PredicateKind::kArithmetic || kind == PredicateKind::kEquality;
  });
  if (computed != left_.end()) return computed;
  const Place first = First([](const CompiledLiteral&) { return true; });
  if (first == left_.end() || !program_.reorder_ || !HasRules(rule_.body[*first])) return first;
  const Place extensional = First([&](const CompiledLiteral& literal) {
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

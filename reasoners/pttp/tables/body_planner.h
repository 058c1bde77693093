// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_BODY_PLANNER_H_
#define LATCHWORK_PTTP_BODY_PLANNER_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reasoners/pttp/tables/table_code.h"
#include "reasoners/pttp/tables/table_plan.h"

namespace latchwork::pttp {

/// Puts the literals of a body in the order in which the machine would select them, as code.
class BodyPlanner {
 public:
  BodyPlanner(TableProgram& program, const Contrapositive& rule)
      : program_(program), rule_(rule), code_(*program.functors_, rule.slots) {}

  CodeMaker& code() { return code_; }
  /// `component`: of the rule's head. False when the literals cannot be put in order.
  bool Plan(std::uint32_t component, std::vector<TableStep>& steps);

 private:
  using Place = std::vector<std::size_t>::iterator;

  bool HasRules(const CompiledLiteral& literal) const;
  PredicateKind KindOf(const CompiledLiteral& literal) const;
  bool IsReady(const CompiledLiteral& literal) const;
  bool HasBoundArgument(const CompiledLiteral& literal) const;
  template <typename Wanted>
  Place First(Wanted&& wanted);
  Place Choose();
  TableStep::Kind StepKind(const CompiledLiteral& literal) const;
  TableStep MakeStep(const CompiledLiteral& literal, std::uint32_t component);
  void MakeCode(const CompiledLiteral& literal, TableStep& step);
  static void NoteDistinctRows(std::vector<TableStep>& steps);

  TableProgram& program_;
  const Contrapositive& rule_;
  CodeMaker code_;
  std::vector<std::size_t> left_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_BODY_PLANNER_H_

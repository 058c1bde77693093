// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_REACTIVE_PLAN_H_
#define LATCHWORK_ICARUS_REACTIVE_PLAN_H_

#include <cstdint>
#include <string>
#include <vector>

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/source_tree.h"

namespace latchwork::icarus {

enum class PlanNodeKind : std::uint8_t {
  kGoal,     ///< Of a teleo-reactive tree: where it is True there is nothing to do.
  kWhen,     ///< What a teleo-reactive tree does under its conditions; its children are deeper.
  kAchieve,  ///< A goal of a universal plan; its children are the ways to achieve it.
  kBy,       ///< One way: under its conditions, once its children are True, its acts.
  kCall,     ///< Another plan of the file, as a goal.
};

struct PlanNode {
  PlanNodeKind kind = PlanNodeKind::kGoal;
  FormId form = kNoForm;
  std::string label;               ///< The name of its skill; empty: to be made up.
  std::vector<FormId> conditions;  ///< {calls}, (facts) and (not ...) of them.
  std::vector<FormId> acts;        ///< {calls}; or, of kWhen and kCall, one call of another plan.
  std::vector<PlanNode> children;
};

/// A teleo-reactive tree (Nilsson 1994; Benson and Nilsson 1995) or a universal plan (Schoppers
/// 1987): which act fits the present state of the world.
struct ReactivePlan {
  bool universal = false;
  FormId form = kNoForm;
  std::string name;  ///< As written.
  std::vector<std::string> parameters;
  PlanNode root;
};

/// The plans of one file. The forms are those of `source`.
struct ReactivePlanFile {
  SourceTree source;
  std::vector<ReactivePlan> plans;
  Findings findings;
};

/// Reads a file of
///     (teleo-reactive Name (?x ...) (goal clause ...)
///       (when [Label] clause ... do act ... (when ...) ...) ...)
///     (universal-plan Name (?x ...)
///       (achieve [Label] clause ... (by act ... (if clause ...) (achieve ...) ...) ...))
/// All mistakes are findings; with errors the plans are not whole.
ReactivePlanFile ReadReactivePlans(std::string text, std::string file);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_REACTIVE_PLAN_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLE_PLAN_H_
#define LATCHWORK_PTTP_TABLE_PLAN_H_

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "reasoners/pttp/predicates.h"
#include "reasoners/pttp/program.h"
#include "reasoners/pttp/reach.h"

namespace latchwork::pttp {

/// A body literal at the place where it is solved. What is bound there is known beforehand, since
/// every answer is ground.
struct TableStep {
  enum class Kind : std::uint8_t {
    kFacts,       ///< A predicate without rules.
    kCall,        ///< One with rules: answers of a table.
    kArithmetic,  ///< A comparison.
    kUnify,       ///< `=` with a ground side.
    kDiffer,      ///< `!=`.
    kAttachment,
    kClosing,  ///< The denial of a minimized atom.
  };
  Kind kind = Kind::kFacts;
  bool recursive = false;  ///< kCall: the table may need what this step is part of.
  std::uint32_t key = 0;   ///< Signed predicate.
  const CompiledLiteral* literal = nullptr;
  std::uint64_t ground = 0;          ///< A bit for each argument that is ground by then.
  std::vector<std::uint32_t> binds;  ///< The slots that the step gives a value.
};

/// A rule for calls that bind certain arguments, its body in the order of solving.
struct TablePlan {
  const Contrapositive* rule = nullptr;
  std::vector<TableStep> steps;
};

/// How the rules of a reach are evaluated with tables; made bit by bit, when calls need them. Fits
/// when no reduction step is possible, closing and recursion do not mix, recursive rules make no
/// new terms, and every answer is ground.
class TableProgram {
 public:
  TableProgram(const Predicates& predicates, const Reach& reach, bool reorder);

  bool fits() const { return fits_; }
  void GiveUp() { fits_ = false; }
  const Reach& reach() const { return *reach_; }
  /// Whether the predicate can lead to itself.
  bool IsRecursive(std::uint32_t key) const { return components_[key].recursive; }

  /// The rules of a predicate for calls with these arguments ground. Null when they do not fit.
  const std::vector<TablePlan>* PlansFor(std::uint32_t key, std::uint64_t ground);
  /// For a query, whose literals stay where they are while the plan is in use. `given`: its
  /// variables have values from the start.
  bool PlanQuery(const Contrapositive& query, bool given, TablePlan& plan) const;

 private:
  struct Component {
    std::uint32_t number = 0;
    bool recursive = false;
  };
  struct Plans {
    std::vector<TablePlan> plans;
    bool fits = true;
  };
  class ComponentFinder;
  class BodyPlanner;

  bool Check() const;
  bool CheckRule(const Contrapositive& rule, std::uint32_t key) const;
  bool IsClosing(const CompiledLiteral& literal) const;

  const Predicates* predicates_;
  const Reach* reach_;
  bool reorder_;
  bool fits_ = false;
  std::vector<Component> components_;  ///< By signed predicate.
  std::unordered_map<std::uint64_t, Plans> plans_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLE_PLAN_H_

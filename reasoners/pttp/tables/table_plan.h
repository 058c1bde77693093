// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLE_PLAN_H_
#define LATCHWORK_PTTP_TABLE_PLAN_H_

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "latchwork/logic/arithmetic.h"
#include "reasoners/pttp/tables/table_code.h"
#include "reasoners/pttp/terms/functors.h"
#include "reasoners/pttp/theory/predicates.h"
#include "reasoners/pttp/theory/program.h"
#include "reasoners/pttp/theory/reach.h"

namespace latchwork::pttp {

struct TableCall;

/// How many arguments a literal in a table program has at most.
inline constexpr std::uint32_t kMostArguments = 32;

/// A body literal at the place where it is solved, as code. What is bound there is known
/// beforehand, since every answer is ground.
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
  bool positive = true;
  /// It fails for the row that an earlier step took, which is the only one where the first of the
  /// operands tells rows apart: as in "no object has two distances".
  bool wants_another_row = false;
  logic::Arithmetic::Predicate comparison{};
  PredicateId predicate = 0;
  std::uint32_t arity = 0;
  std::vector<Operand> operands;  ///< The arguments that are ground by then.
  /// For the others of a row; kUnify: for the side that is not ground, matched with the other.
  MatchCode pattern;
  TableCall* call = nullptr;  ///< kCall.
};

/// A rule for calls that bind certain arguments, its body in the order of solving.
struct TablePlan {
  const Contrapositive* rule = nullptr;
  MatchCode call;  ///< For the arguments of the call that are ground.
  std::vector<TableStep> steps;
  std::vector<Operand> answer;  ///< The arguments of the head that the call leaves open.
};

/// A predicate with rules, called with these arguments ground.
struct TableCall {
  std::uint32_t key = 0;     ///< Signed predicate.
  std::uint64_t ground = 0;  ///< A bit for each argument.
  bool recursive = false;    ///< The predicate can lead to itself.
  bool whole = false;        ///< All arguments are ground: there is one answer at most.
  std::size_t label = 0;     ///< Calls with the same label have the same answers.
  bool planned = false;
  bool fits = true;
  std::vector<TablePlan> plans;  ///< By rule.
};

/// How the rules of a reach are evaluated with tables; made bit by bit, when calls need them. Fits
/// when no reduction step is possible, closing and recursion do not mix, recursive rules make no
/// new terms, and every answer is ground.
class TableProgram {
 public:
  TableProgram(const Predicates& predicates, const Functors& functors, const Reach& reach,
               bool reorder);

  bool fits() const { return fits_; }
  void GiveUp() { fits_ = false; }
  const Reach& reach() const { return *reach_; }

  /// The rules for a call, planned when they are first asked for. Null when they do not fit.
  const std::vector<TablePlan>* PlansFor(TableCall& call);
  /// For a query, whose literals stay where they are while the plan is in use. `given`: its
  /// variables have values from the start.
  bool PlanQuery(const Contrapositive& query, bool given, TablePlan& plan);

 private:
  struct Component {
    std::uint32_t number = 0;
    bool recursive = false;
  };
  class ComponentFinder;
  friend class BodyPlanner;

  bool Check() const;
  bool CheckRule(const Contrapositive& rule, std::uint32_t key) const;
  bool IsClosing(const CompiledLiteral& literal) const;
  bool PlanRule(const TableCall& call, TablePlan& plan);
  TableCall& CallOf(std::uint32_t key, std::uint32_t arity, std::uint64_t ground);

  const Predicates* predicates_;
  const Functors* functors_;
  const Reach* reach_;
  bool reorder_;
  bool fits_ = false;
  std::vector<Component> components_;  ///< By signed predicate.
  std::unordered_map<std::uint64_t, TableCall> calls_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLE_PLAN_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_REACH_H_
#define LATCHWORK_PTTP_REACH_H_

#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/pttp/theory/predicate_set.h"
#include "reasoners/pttp/theory/predicates.h"
#include "reasoners/pttp/theory/program.h"

namespace latchwork::pttp {

/// What a search from given goals can use of a program: rules whose every subgoal something could
/// prove.
struct Reach {
  /// By signed predicate.
  std::vector<std::vector<const Contrapositive*>> rules;
  std::vector<bool> may_reduce;  ///< By signed predicate: the complement can be an ancestor.
  bool viable = true;            ///< No start goal is beyond proof.
  bool reduction_free = true;    ///< As in a Horn theory: no goal can meet its complement above it.
  bool recursive = false;        ///< A goal can lead to a goal of its own predicate.
  std::uint32_t height = 0;      ///< Longest chain of goals below a goal; when not recursive.
  bool closing = true;           ///< Minimized predicates are closed.
  /// By signed predicate: what proves it may depend on `closing`.
  std::vector<bool> closes;
  PredicateSet sees;  ///< Whose facts it may use.
  bool asks = false;  ///< Closings or attachments may see more.

  std::span<const Contrapositive* const> RulesFor(std::uint32_t signed_predicate) const {
    if (signed_predicate >= rules.size()) return {};
    return rules[signed_predicate];
  }
  bool MayReduce(std::uint32_t signed_predicate) const {
    return signed_predicate < may_reduce.size() && may_reduce[signed_predicate];
  }
};

/// `closing`: negative literals of minimized predicates can be proved by closing them.
Reach FindReach(const Program& program, const Predicates& predicates,
                std::span<const Contrapositive* const> starts, bool closing);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_REACH_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_ELEVATORS_SHORTEST_PLAN_H_
#define LATCHWORK_PLUGINS_ELEVATORS_SHORTEST_PLAN_H_

#include <span>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/attachment.h"

namespace latchwork::elevators {

/// shortest_plan(N): the least N for which reach_in(N) is provable, N = 0 .. longest; false when
/// there is none. "No shorter plan" is a statement about provability, so the prover is asked
/// instead of the theory.
class ShortestPlan final : public sdk::Attachment {
 public:
  ShortestPlan(std::int64_t longest, logic::SymbolTable& symbols);

  const Signature& signature() const override;
  void Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override;

 private:
  std::vector<std::vector<logic::Literal>> queries_;  ///< By N.
};

}  // namespace latchwork::elevators

#endif  // LATCHWORK_PLUGINS_ELEVATORS_SHORTEST_PLAN_H_

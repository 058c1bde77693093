// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PTTP_REASONER_H_
#define LATCHWORK_PTTP_PTTP_REASONER_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/reasoner.h"
#include "reasoners/pttp/search/engine.h"
#include "reasoners/pttp/search/goal_memory.h"
#include "reasoners/pttp/search/query.h"
#include "reasoners/pttp/theory/theory.h"

namespace latchwork::pttp {

/// Theories in TPTP syntax, decided by model elimination. Complete for first-order logic within the
/// budget; minimized predicates are closed by bounded proof. Source: Stickel 1988; LSA (IJCAI-99),
/// section 5.
class PttpReasoner final : public sdk::Reasoner {
 public:
  std::string_view language() const override { return "tptp"; }
  std::span<const sdk::ParameterSpec> parameters() const override;

  logic::Diagnostics Load(const sdk::Body& body, const sdk::Parameters& parameters,
                          logic::SymbolTable& symbols) override;
  void Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
              sdk::Decision& decision) override;
  void Admit(std::span<const sdk::Latch> latches, std::size_t port,
             std::span<const logic::Fact> batch, const sdk::Budget& budget,
             std::vector<sdk::Refusal>& refused) override;
  logic::Diagnostics Tell(std::string_view text) override;
  logic::Diagnostics Retract(std::string_view name) override;
  sdk::Derivation Explain(std::size_t conclusion) override;
  std::optional<sdk::Explanation> ExplainAssumption(std::size_t assumption) override;
  std::optional<sdk::Explanation> WhyNot(const logic::Atom& pattern) override;

 private:
  class GoalSink;
  class ExplainSink;
  class ConflictSink;

  /// A clause without a positive literal: what refutes it shows a contradiction.
  struct Denial {
    Query query;
    Validity unrefuted;
  };

  bool LoadLatches(std::span<const sdk::Latch> latches);
  bool MayReuse(const sdk::Budget& budget) const;
  bool IsConsistent(sdk::Decision& decision);
  bool Refutes(Denial& denial);
  void SolveGoal(std::size_t goal, sdk::Decision& decision);
  void Remember(std::size_t goal, std::size_t first, const sdk::Decision& decision);
  void Recall(std::size_t goal, sdk::Decision& decision);
  sdk::Conclusion& AddConclusion(sdk::Decision& decision);
  void Begin(const sdk::Budget& budget);
  void Finish(sdk::Decision& decision);
  void Recompile();
  void CompileGoals();
  void VoidMemory();
  std::string Conflict(const logic::Fact& fact, std::uint32_t depth);
  /// The budget of the last decision, without what stopped it from outside.
  sdk::Budget BudgetToExplain() const;
  /// Empty: there is no proof within the budget.
  sdk::Derivation DerivationOf(const logic::Atom& atom, const sdk::Budget& budget);

  sdk::Body body_;
  logic::SymbolTable* symbols_ = nullptr;
  std::unique_ptr<Theory> theory_;
  std::unique_ptr<Engine> engine_;
  std::vector<std::unique_ptr<Query>> goals_;
  std::vector<GoalMemory> memories_;  ///< By goal.
  std::vector<std::unique_ptr<Denial>> denials_;
  std::vector<std::size_t> sources_;  ///< One per latch.
  std::size_t admitted_ = 0;          ///< The source that Admit fills.
  Query denied_;                      ///< The denial of a fact that Admit looks at.
  VariantTable answers_;
  std::uint64_t consistency_inferences_ = 0;
  bool cache_decisions_ = true;
  bool equality_axioms_ = false;

  bool decided_ = false;  ///< `last_` stands for what is loaded now.
  bool explainable_ = false;
  sdk::Budget last_budget_;
  sdk::Decision last_;
  std::size_t conclusions_ = 0;
  std::vector<std::size_t> place_;  ///< Of assumptions.
  bool undecided_ = false;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PTTP_REASONER_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_EXACT_DECIDER_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_EXACT_DECIDER_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "latchwork/sdk/explanation.h"
#include "latchwork/sdk/reasoner.h"
#include "reasoners/circumscription/evaluation/evaluator.h"
#include "reasoners/circumscription/exact/compiled_goals.h"
#include "reasoners/circumscription/exact/search_decider.h"
#include "reasoners/circumscription/rules/program.h"

namespace latchwork::circumscription {

/// Decides the goals of a body by exact circumscription of what is ground in a cycle: evaluation of
/// its rules where that is a certificate of the only minimal world, else search. Not thread-safe.
class ExactDecider {
 public:
  /// `body` and `symbols` outlive it.
  ExactDecider(const sdk::Body& body, logic::SymbolTable& symbols, bool is_brave);

  /// Why the clauses cannot be grounded, each with its place; empty: they are loaded.
  logic::Diagnostics Compile(std::vector<logic::Clause> clauses);

  /// False: this cycle cannot be decided; `reason()` says why, and `decision` is not filled.
  bool Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
              sdk::Decision& decision);
  const std::string& reason() const { return reason_; }
  /// Why the default of an assumption was made, or what retracted it, in the last decision. Nothing
  /// where there is no such assumption, or the search for reasons came to no end.
  std::optional<sdk::Explanation> ExplainAssumption(std::size_t assumption) const;
  /// Why no instance of `pattern` is concluded, or how the first one is; as above. `decision`: the
  /// last one that was filled.
  std::optional<sdk::Explanation> WhyNot(const sdk::Decision& decision,
                                         const logic::Atom& pattern) const;
  sdk::Derivation Explain(const sdk::Decision& decision, std::size_t conclusion) const;

 private:
  bool Search(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
              sdk::Decision& decision);
  bool SearchWithRest(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                      sdk::Decision& decision);
  void Fill(sdk::Decision& decision);
  void AnswerGoals(sdk::Decision& decision);
  void ListAssumptions(sdk::Decision& decision) const;
  void ListConclusion(std::size_t goal, std::uint32_t row, sdk::Conclusion& conclusion);
  std::optional<FactRef> FindInstance(const logic::Atom& pattern) const;
  void Collect(const FactInfo& info, std::vector<std::size_t>& assumptions);

  const sdk::Body& body_;
  logic::SymbolTable& symbols_;
  Program program_;
  Evaluator evaluator_;
  CompiledGoals goals_;
  SearchDecider search_;
  bool must_search_;                ///< No certificate is sought.
  bool searched_ = false;           ///< For the last decision.
  bool has_model_ = false;          ///< Without a search: all that holds was found.
  std::vector<std::string> ports_;  ///< Of the latches of the last decision.
  std::vector<FactRef> open_;
  std::vector<FactRef> conclusions_;  ///< The answers behind the conclusions.
  std::string reason_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_EXACT_DECIDER_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_SEARCH_DECIDER_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_SEARCH_DECIDER_H_

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "latchwork/sdk/explanation.h"
#include "latchwork/sdk/reasoner.h"
#include "reasoners/circumscription/engine/engine.h"
#include "reasoners/circumscription/evaluation/evaluator.h"
#include "reasoners/circumscription/evaluation/instance_sink.h"
#include "reasoners/circumscription/exact/compiled_goals.h"
#include "reasoners/circumscription/exact/ground_store.h"
#include "reasoners/circumscription/exact/reasons.h"
#include "reasoners/circumscription/rules/program.h"

namespace latchwork::circumscription {

/// Decides goals where there may be several minimal worlds: grounds what may hold in a cycle and
/// asks the engine for minimal models. Instances are kept from cycle to cycle, and with them what
/// the engine learnt, as long as no new ones come. Not thread-safe.
class SearchDecider final : private InstanceSink {
 public:
  /// `body` and `symbols` outlive it.
  SearchDecider(const sdk::Body& body, logic::SymbolTable& symbols, bool is_brave);

  logic::Diagnostics Compile(std::vector<logic::Clause> clauses);

  /// False: this cycle cannot be decided; `reason()` says why.
  bool Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
              sdk::Decision& decision);
  const std::string& reason() const { return evaluator_.refusal(); }
  sdk::Derivation Explain(const sdk::Decision& decision, std::size_t conclusion) const;
  /// Why the default of an assumption of the last decision was made, or what retracted it. Nothing:
  /// there is no such assumption, or the search for reasons came to no end.
  std::optional<sdk::Explanation> ExplainAssumption(std::size_t assumption) const;
  /// Why no instance of `pattern` is concluded, or how the first one is. Nothing: as above, or the
  /// budget did not suffice to ground the cycle.
  std::optional<sdk::Explanation> WhyNot(const sdk::Decision& decision,
                                         const logic::Atom& pattern) const;

 private:
  enum class Standing : std::uint8_t { kConcluded, kRefuted, kUndecided, kUnknown };

  Atom AtomOf(std::size_t relation, std::span<const Value> cells) override {
    return store_.AtomOf(relation, cells);
  }
  void Instance(std::size_t clause, std::span<const Literal> literals) override;
  void Give(std::size_t relation, std::span<const Value> cells) override {
    store_.Give(relation, cells);
  }
  bool IsCertain(std::span<const Literal> literals) override;

  Evaluator::End Ground(std::span<const sdk::Latch> latches, const sdk::Budget& budget);
  void Prepare();
  void Forget();
  void Answer(sdk::Decision& decision);
  void AnswerGoal(std::size_t goal, sdk::Decision& decision);
  Standing StandingOf(Literal literal);
  void ListAssumptions(sdk::Decision& decision);
  void ListAssumption(std::size_t relation, std::uint32_t row, sdk::Decision& decision);
  void ListStates(sdk::Decision& decision);
  void ListGrounds(sdk::Decision& decision);
  std::optional<Core> CoreOf(Atom atom, Spending* spending = nullptr) const;
  Atom FirstOpen(const logic::Atom& pattern) const;

  const sdk::Body& body_;
  logic::SymbolTable& symbols_;
  bool is_brave_;
  Program program_;
  Evaluator evaluator_;
  CompiledGoals goals_;
  GroundStore store_;
  std::size_t instances_ = 0;       ///< Of this cycle.
  std::size_t prepared_ = 0;        ///< Size of the store that the engine stands for.
  std::size_t prepared_atoms_ = 0;  ///< And its atoms.
  std::unique_ptr<Engine> engine_;
  std::vector<std::string> ports_;  ///< Of the latches.
  std::vector<Literal> latches_;
  std::vector<Atom> assumed_;    ///< By assumption.
  std::vector<Literal> made_;    ///< By assumption; 0 where it is retracted.
  std::vector<Atom> concluded_;  ///< By conclusion; 0: the body says so.
  std::vector<Atom> undecided_;  ///< By undecided goal instance.
  bool is_unknown_ = false;
  bool is_answered_ = false;  ///< The budget was enough to ground the last cycle.
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_SEARCH_DECIDER_H_

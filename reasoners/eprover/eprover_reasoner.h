// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_EPROVER_EPROVER_REASONER_H_
#define LATCHWORK_EPROVER_EPROVER_REASONER_H_

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/reasoner.h"
#include "reasoners/eprover/closings.h"
#include "reasoners/eprover/question.h"
#include "reasoners/pttp/theory/theory.h"

namespace latchwork::eprover {

/// Theories in TPTP syntax without arithmetic and attachments, decided by the prover E: a process
/// for each question. What a minimized predicate is not proved to hold of is denied in the
/// questions that come after.
class EproverReasoner final : public sdk::Reasoner {
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

 private:
  /// Makes questions from the clauses; what E cannot take is a diagnostic.
  logic::Diagnostics Compile();
  logic::Diagnostics CheckFragment() const;
  logic::Diagnostics Change(const std::function<logic::Diagnostics(pttp::Theory&)>& change);
  bool IsUnchanged(std::span<const sdk::Latch> latches, const sdk::Budget& budget);
  void Collect(std::span<const sdk::Latch> latches, std::size_t without);
  std::string AxiomsOf(std::span<const logic::Fact> facts) const;
  Reply Ask(const std::string& axioms, const logic::Atom* pattern, std::size_t answers,
            sdk::Decision& decision);
  /// False: the decision is over, and says why.
  bool CheckConsistency(const std::string& axioms, sdk::Decision& decision);
  bool Close(const Closings::Closing& closing, std::string& axioms, sdk::Decision& decision);
  bool AnswerGoal(std::size_t goal, const std::string& axioms, sdk::Decision& decision);
  static bool Heed(const Reply& reply, sdk::Decision& decision);
  void DecideAnew(sdk::Decision& decision);

  sdk::Body body_;
  logic::SymbolTable* symbols_ = nullptr;
  std::filesystem::path program_;
  std::unique_ptr<pttp::Theory> theory_;
  std::vector<logic::Clause> clauses_;
  std::string axioms_;  ///< The clauses.
  Closings closings_;
  bool has_denials_ = false;
  QuestionLimits limits_;
  std::uint64_t most_clauses_ = 0;
  bool cache_decisions_ = true;

  std::vector<logic::Fact> facts_;  ///< Of body, clauses and latches.
  bool decided_ = false;            ///< `last_` stands for what is loaded, and for versions_.
  std::vector<std::uint64_t> versions_;
  sdk::Budget last_budget_;
  sdk::Decision last_;
};

}  // namespace latchwork::eprover

#endif  // LATCHWORK_EPROVER_EPROVER_REASONER_H_

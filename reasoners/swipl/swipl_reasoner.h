// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SWIPL_SWIPL_REASONER_H_
#define LATCHWORK_SWIPL_SWIPL_REASONER_H_

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/process/companion.h"
#include "latchwork/sdk/reasoner.h"
#include "reasoners/pttp/theory/theory.h"
#include "reasoners/swipl/conversation.h"
#include "reasoners/swipl/names.h"
#include "reasoners/swipl/rule_writer.h"

namespace latchwork::swipl {

/// Theories in TPTP syntax as a Prolog program in the style of PTTP, run by SWI-Prolog in a process
/// that is kept alive. Decides as the prover does, by code that has nothing in common with it but
/// the reading of theories.
class SwiplReasoner final : public sdk::Reasoner {
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
  class DecisionListener;
  class AdmissionListener;
  /// The rows of a predicate, as Prolog reads them.
  using Rows = std::map<std::size_t, std::string>;
  struct Port {
    std::uint64_t version = 0;
    bool is_loaded = false;
    Rows rows;
  };

  void Render();
  bool LoadLatches(std::span<const sdk::Latch> latches);
  void AddRow(const logic::Fact& fact, Rows& rows);
  /// Starts the program where it is not running; false: `decision` or nobody learns why.
  bool Start(std::string& problem);
  /// Commands that bring the facts of Prolog up to those of the latches but one.
  std::string Facts(std::size_t without);
  Conversation::End Converse(const std::string& command, const sdk::Budget& budget,
                             Listener& listener, sdk::Decision& decision);
  void DecideAnew(const sdk::Budget& budget, sdk::Decision& decision);
  bool MayOffend(const logic::Fact& fact);
  std::string Item(std::size_t index, const logic::Fact& fact, std::uint32_t depth);

  sdk::Body body_;
  logic::SymbolTable* symbols_ = nullptr;
  std::filesystem::path program_;
  std::unique_ptr<pttp::Theory> theory_;
  std::vector<logic::Clause> clauses_;
  Names names_;
  std::unique_ptr<RuleWriter> writer_;
  Rendering rendering_;
  Rows base_;  ///< Of the body.
  std::vector<Port> ports_;
  Rows sent_;  ///< What the program knows.
  process::Companion companion_;
  bool unique_names_ = false;
  bool equality_axioms_ = false;
  bool cache_decisions_ = true;
  std::uint64_t consistency_inferences_ = 0;
  double seconds_ = 0;
  std::uint64_t memory_mb_ = 0;

  bool decided_ = false;  ///< `last_` stands for what is loaded now.
  sdk::Budget last_budget_;
  sdk::Decision last_;
};

}  // namespace latchwork::swipl

#endif  // LATCHWORK_SWIPL_SWIPL_REASONER_H_

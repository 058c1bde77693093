// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_ICARUS_REASONER_H_
#define LATCHWORK_ICARUS_ICARUS_REASONER_H_

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/reasoner.h"
#include "reasoners/icarus/body/admission.h"
#include "reasoners/icarus/body/attachment_host.h"
#include "reasoners/icarus/body/cycle_watch.h"
#include "reasoners/icarus/body/latch_facts.h"
#include "reasoners/icarus/body/term_bridge.h"
#include "reasoners/icarus/language/program_text.h"
#include "reasoners/icarus/learning/layer_learning.h"
#include "reasoners/icarus/machine/interpreter.h"

namespace latchwork::icarus {

/// Icarus programs as bodies of layers. What the latches hold and the parameters are facts of
/// short-term memory; attachments are functions of conditions; the acts of a cycle are its
/// conclusions. The program names its top call, (top (Skill ...)). Memory and the states of
/// sequences stay from cycle to cycle, so Decide is a function of them, too. Source: Shapiro and
/// Langley (Agents'99).
class IcarusReasoner final : public sdk::Reasoner {
 public:
  std::string_view language() const override { return "icarus"; }
  bool keeps_memory() const override { return true; }
  std::span<const sdk::ParameterSpec> parameters() const override;

  logic::Diagnostics Load(const sdk::Body& body, const sdk::Parameters& parameters,
                          logic::SymbolTable& symbols) override;
  /// kUnknown when a limit was hit, even if acts were found. kFailed when a fault, by the parameter
  /// `faults`, ends the cycle. Else `message` tells of the first fault.
  void Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
              sdk::Decision& decision) override;
  /// Refuses nothing: programs have no hard axioms.
  void Admit(std::span<const sdk::Latch> latches, std::size_t port,
             std::span<const logic::Fact> batch, const sdk::Budget& budget,
             std::vector<sdk::Refusal>& refused) override;
  /// Skills, constants and the top of these names are replaced, others added, facts stored. Memory,
  /// and the sequences that stay as they are, go on.
  logic::Diagnostics Tell(std::string_view text) override;
  /// Takes out a skill that no other calls, or a constant that is not used.
  logic::Diagnostics Retract(std::string_view name) override;
  /// Goes through the cycle again, in a copy of memory as it is now: where the program changed what
  /// the act rests on after it was found, the derivation is empty.
  sdk::Derivation Explain(std::size_t conclusion) override;

  /// Who is told of the cycles to come; null: nobody. Call it after Load.
  void SetWatch(CycleWatch* watch);
  const NamePool& names() const { return names_; }
  const Program& program() const { return loaded_.file->program; }

 private:
  /// A program and what runs it.
  struct Loaded {
    ProgramText text;
    std::unique_ptr<ProgramFile> file;  ///< The interpreter keeps references to it.
    std::unique_ptr<Interpreter> interpreter;
    std::size_t top = Interpreter::kNoTop;
    std::unique_ptr<Admission> admission;  ///< Null: the program refuses nothing.
  };
  /// Where a conclusion comes from: an act of the last cycle.
  struct Origin {
    std::size_t act = 0;
    std::size_t call = 0;
  };

  logic::Diagnostics Compile(ProgramText text, Loaded& loaded);
  void SpellNames(const Program& program);
  void Adopt(Loaded loaded, std::size_t first_fact);
  bool SetLatches(std::span<const sdk::Latch> latches);
  void Conclude(const CycleResult& result, sdk::Decision& decision);
  void ConcludeCall(const ActCall& call, Origin origin, sdk::Decision& decision);
  std::size_t GoalOf(const ActCall& call) const;
  void AddConclusion(std::size_t goal, Origin origin, sdk::Decision& decision);
  void Judge(const CycleResult& result, sdk::Decision& decision);
  std::string Text(const Fault& fault) const;

  sdk::Body body_;
  RunOptions options_;
  NamePool names_;
  std::unique_ptr<TermBridge> bridge_;
  std::unique_ptr<AttachmentHost> host_;
  Loaded loaded_;
  std::vector<LatchFacts> latch_facts_;  ///< The first is of the parameters.
  std::vector<std::uint64_t> versions_;
  std::vector<NameId> goal_names_;
  logic::Fact fact_;
  std::vector<logic::Term> terms_;
  std::vector<Origin> origins_;     ///< By conclusion.
  std::vector<logic::Fact> facts_;  ///< The conclusions.
  CycleLimits limits_;              ///< Of the last cycle.
  std::size_t conclusions_ = 0;
  std::string problem_;  ///< The first thing that went wrong outside of the program.
  std::string stopped_;  ///< The fault that stopped the program for good.
  const CycleResult* last_ = nullptr;
  CycleWatch* watch_ = nullptr;
  std::unique_ptr<LayerLearning> learning_;  ///< Refers to what is above it.
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_ICARUS_REASONER_H_

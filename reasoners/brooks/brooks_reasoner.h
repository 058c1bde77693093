// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_BROOKS_BROOKS_REASONER_H_
#define LATCHWORK_BROOKS_BROOKS_REASONER_H_

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "latchwork/sdk/reasoner.h"
#include "reasoners/brooks/behaviour.h"

namespace latchwork::brooks {

/// No reasoner at all: plain reactive behaviours in its place, as the floor that reasoners are
/// measured against. It reads no body but the layer's parameters, and meets the contracts of
/// `avoid` and `seek`, which it knows by their outputs. Source: Brooks (1986).
class BrooksReasoner final : public sdk::Reasoner {
 public:
  std::string_view language() const override { return ""; }
  bool keeps_memory() const override { return true; }
  std::span<const sdk::ParameterSpec> parameters() const override;

  logic::Diagnostics Load(const sdk::Body& body, const sdk::Parameters& parameters,
                          logic::SymbolTable& symbols) override;
  /// A function of the latches and the number of the cycle. kRefuted: nothing to do.
  void Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
              sdk::Decision& decision) override;
  /// Refuses nothing.
  void Admit(std::span<const sdk::Latch> latches, std::size_t port,
             std::span<const logic::Fact> batch, const sdk::Budget& budget,
             std::vector<sdk::Refusal>& refused) override;
  /// There is no text to add to or to take from.
  logic::Diagnostics Tell(std::string_view text) override;
  logic::Diagnostics Retract(std::string_view name) override;
  /// Keeps no derivations.
  sdk::Derivation Explain(std::size_t conclusion) override;

 private:
  std::unique_ptr<Behaviour> behaviour_;
  std::vector<sdk::Goal> goals_;
  std::vector<logic::Fact> acts_;
};

}  // namespace latchwork::brooks

#endif  // LATCHWORK_BROOKS_BROOKS_REASONER_H_

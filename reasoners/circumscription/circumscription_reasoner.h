// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_CIRCUMSCRIPTION_REASONER_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_CIRCUMSCRIPTION_REASONER_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/reasoner.h"
#include "reasoners/circumscription/exact/exact_decider.h"
#include "reasoners/circumscription/options.h"
#include "reasoners/pttp/pttp_reasoner.h"
#include "reasoners/pttp/theory/theory.h"

namespace latchwork::circumscription {

/// Theories in TPTP syntax whose minimized predicates are circumscribed: exactly, where the body
/// can be grounded, else by bounded proof (Amir and Maynard-Reid, LSA, IJCAI-99), for which the
/// prover is used as a library. It also checks what enters the latches.
class CircumscriptionReasoner final : public sdk::Reasoner {
 public:
  std::string_view language() const override { return "tptp"; }
  std::span<const sdk::ParameterSpec> parameters() const override { return LayerOptions(); }

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

  /// Why the default of an assumption of the last decision was made, or which facts of latches
  /// retracted it. Nothing where the decision was bounded, or needed a search.
  std::optional<sdk::Explanation> ExplainAssumption(std::size_t assumption) override;
  /// Why no instance of a goal, or of any other atom, was concluded in the last decision.
  std::optional<sdk::Explanation> WhyNot(const logic::Atom& pattern) override;

  /// Whether decisions are exact now; where they are not, why_bounded() says why.
  bool is_exact() const { return exact_ != nullptr; }
  const std::string& why_bounded() const { return why_bounded_; }

 private:
  logic::Diagnostics CompileExact();
  /// Changes the body for both ways of deciding, or for neither.
  logic::Diagnostics Change(const std::function<logic::Diagnostics(sdk::Reasoner&)>& bounded,
                            const std::function<logic::Diagnostics(pttp::Theory&)>& exact);
  bool IsUnchanged(std::span<const sdk::Latch> latches, const sdk::Budget& budget);
  void DecideBounded(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                     sdk::Decision& decision, std::string_view why);

  sdk::Body body_;
  logic::SymbolTable* symbols_ = nullptr;
  Mode mode_ = Mode::kAuto;
  bool is_brave_ = false;
  pttp::PttpReasoner bounded_;
  std::unique_ptr<pttp::Theory> theory_;
  std::unique_ptr<ExactDecider> exact_;
  std::string why_bounded_;
  bool was_exact_ = false;  ///< The last decision.
  bool reuses_ = true;
  bool decided_ = false;  ///< `last_` stands for what is loaded, and for versions_.
  std::vector<std::uint64_t> versions_;
  sdk::Budget last_budget_;
  sdk::Decision last_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_CIRCUMSCRIPTION_REASONER_H_

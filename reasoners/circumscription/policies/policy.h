// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_POLICIES_POLICY_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_POLICIES_POLICY_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "reasoners/circumscription/engine/engine.h"
#include "reasoners/circumscription/theory/ground_theory.h"

namespace latchwork::circumscription {

/// The closed-world assumptions of the literature, weakest first where they compare:
/// GCWA <= EGCWA, and CCWA <= ECWA (Gelfond, Przymusinska, Przymusinski 1986).
enum class Policy : std::uint8_t {
  kCwa,    ///< Minimized atoms that do not follow are false (Reiter). May contradict itself.
  kGcwa,   ///< Atoms false in all minimal models are false, all atoms minimized (Minker).
  kCcwa,   ///< The same with minimized, varying and fixed atoms.
  kEgcwa,  ///< What holds in all minimal models, all atoms minimized.
  kEcwa,   ///< Circumscription.
};

std::string_view Name(Policy policy);
/// By the name that Name gives.
std::optional<Policy> FindPolicy(std::string_view name);

/// A theory under a policy, with the latches of one cycle. All but kEcwa are parallel: levels are
/// of no account.
class ClosedWorld {
 public:
  ClosedWorld(const GroundTheory& theory, std::span<const Literal> latches, Policy policy,
              const EngineOptions& options = {});

  /// Whether the closed theory entails the disjunction.
  Answer EntailsAlways(std::span<const Literal> clause) { return engine_->EntailsAlways(clause); }
  /// Whether the closed theory has a model that satisfies the conjunction.
  Answer HoldsSomewhere(std::span<const Literal> conjunction) {
    return engine_->HoldsSomewhere(conjunction);
  }
  Answer IsInconsistent() { return engine_->IsInconsistent(); }
  /// The atoms that kCwa, kGcwa and kCcwa made false; with `complete` false, a budget ran out
  /// before all were known and answers are not to be relied on.
  const std::vector<Atom>& closed() const { return closed_; }
  bool complete() const { return complete_; }

 private:
  void CloseAtoms(const GroundTheory& theory, Policy policy, const EngineOptions& options);

  std::vector<Atom> closed_;
  bool complete_ = true;
  std::unique_ptr<Engine> engine_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_POLICIES_POLICY_H_

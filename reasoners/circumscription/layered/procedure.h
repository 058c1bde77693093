// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_PROCEDURE_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_PROCEDURE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "reasoners/circumscription/engine/engine.h"
#include "reasoners/circumscription/layered/layered_theory.h"

namespace latchwork::circumscription {

/// What of its goals a layer hands down.
enum class Transfer : std::uint8_t {
  kSingle,   ///< The instances that are proved.
  kOpen,     ///< Those, and each undecided one behind a fixed premise of unknown value.
  kRefined,  ///< Every state of all goals that some minimal model has, one after the other.
};

inline constexpr std::array<Transfer, 3> kTransfers = {Transfer::kSingle, Transfer::kOpen,
                                                       Transfer::kRefined};
std::string_view Name(Transfer transfer);
std::optional<Transfer> FindTransfer(std::string_view name);

/// In all minimal models, in none, in some; or the budget ran out.
enum class GoalStatus : std::uint8_t { kProved, kRefuted, kOpen, kUnknown };
std::string_view Name(GoalStatus status);

struct ProcedureOptions {
  EngineOptions engine;
  std::size_t max_states = 4096;  ///< Of one layer's goals; with more they count as undecided.
};

/// What one layer came to.
struct LayerOutcome {
  Verdict has_model = Verdict::kUnknown;  ///< No: it hands down nothing.
  std::vector<Atom> goals;                ///< Those that a bridge to the layer below comes from.
  std::vector<GoalStatus> statuses;       ///< Of `goals`.
  std::size_t states = 0;                 ///< That it handed down.
};

/// The mechanical procedure for a layered theory: from the top down each layer on its own engine,
/// its goals handed on. A bridge that contradicts a layer is given up there.
class Procedure {
 public:
  Procedure(const LayeredTheory& theory, Transfer transfer, const ProcedureOptions& options = {});

  /// Whether the lowest layer concludes the disjunction of its literals. Where a budget ran out,
  /// yes is still said only where it would be without bounds; what is not known is unknown.
  Answer Entails(std::span<const Literal> clause);
  /// The lowest layer first.
  const std::vector<LayerOutcome>& outcomes() const { return outcomes_; }

 private:
  /// Values of premises; those that are missing may be either.
  using State = std::vector<Literal>;

  void RunLayer(std::size_t layer);
  void SetState(std::size_t layer, const State& state);
  /// Status of each goal under the state that is set.
  std::vector<GoalStatus> Decide(std::size_t layer);
  State Handed(const std::vector<GoalStatus>& statuses, const std::vector<Atom>& premises) const;
  /// Adds the states of the goals from `next` on that can hold together with `goals`.
  void Enumerate(std::size_t layer, std::size_t next, std::vector<Literal>& goals,
                 std::vector<State>& states);
  void Limit(std::vector<State>& states);

  Transfer transfer_;
  ProcedureOptions options_;
  std::vector<BridgedTheory> theories_;
  std::vector<std::unique_ptr<Engine>> engines_;
  std::vector<LayerOutcome> outcomes_;
  std::vector<State> states_;  ///< For the layer that is next.
  bool exact_ = true;          ///< states_ are those that there would be without bounds.
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_PROCEDURE_H_

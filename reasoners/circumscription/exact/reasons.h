// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_REASONS_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_REASONS_H_

#include <optional>
#include <span>
#include <string>

#include "latchwork/sdk/decision.h"
#include "reasoners/circumscription/engine/minimal_core.h"
#include "reasoners/circumscription/evaluation/evaluator.h"
#include "reasoners/circumscription/exact/ground_store.h"

namespace latchwork::circumscription {

/// Which of `assumed` are needed to conclude `conclusion` classically from the theory and the
/// latches, and which clauses and latches: none can be left out. Nothing: it does not follow so.
/// The contrary of the conclusion stands among the latches of the core. `spending`: what the search
/// is charged to, if to anything; where it ends, the core may be larger than need be, or none.
std::optional<Core> ReasonsFor(const GroundTheory& theory, std::span<const Literal> latches,
                               std::span<const Literal> assumed, Literal conclusion,
                               Spending* spending = nullptr);

/// The fact that an atom of the store stands for. `bank`: that of the evaluator that filled it.
logic::Fact FactOf(const GroundStore& store, const ValueBank& bank, const Relations& relations,
                   Atom atom);

/// "body and latches contradict each other: clauses 'x', 'y' with p(a)".
std::string Describe(const GroundStore& store, const Evaluator& evaluator,
                     const std::optional<Core>& core);

/// The facts, assumptions and clauses of a core as steps; the last one, which concludes `fact`,
/// rests on all of them. `ports`: names of the latches.
sdk::Derivation DeriveFromCore(const GroundStore& store, const Evaluator& evaluator,
                               std::span<const std::string> ports, const std::optional<Core>& core,
                               const logic::Fact& fact);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_REASONS_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_ENGINE_PROOF_H_
#define LATCHWORK_PTTP_ENGINE_PROOF_H_

#include "reasoners/pttp/proofs/proof_printer.h"
#include "reasoners/pttp/search/engine.h"
#include "reasoners/pttp/search/machine.h"

namespace latchwork::pttp {

/// Hands all that a recorded proof consists of to a printer of the engine's clauses. To be called
/// while the proof is valid.
void AddProof(const Proof& proof, Engine& engine, ProofPrinter& printer);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_ENGINE_PROOF_H_

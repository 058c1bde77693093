// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_STRATEGY_RUN_H_
#define LATCHWORK_PTTP_STRATEGY_RUN_H_

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "latchwork/logic/symbol.h"
#include "reasoners/pttp/proofs/proof_printer.h"
#include "reasoners/pttp/strategies/prover.h"
#include "reasoners/pttp/strategies/prover_problem.h"
#include "reasoners/pttp/strategies/schedule.h"

namespace latchwork::pttp {

/// What a strategy came to.
enum class StrategyEnd : std::uint8_t {
  kRefuted,
  kModel,    ///< There is no refutation.
  kGaveUp,   ///< It was at its end and knows nothing.
  kSlice,    ///< Its time was over.
  kStopped,  ///< The whole attempt must end.
  kMemory,
};

/// What all strategies of an attempt are given. Nothing of it is changed but the symbol table,
/// which may be.
struct ProverTask {
  const ProverProblem& problem;
  logic::SymbolTable& symbols;
  ProofSources sources;
  const ProverOptions& options;
};

/// What one strategy may spend, beside the deadline and the cancellation of the options.
struct StrategyLimits {
  double cpu_seconds;  ///< Of the calling thread.
  std::uint64_t inferences;
  std::size_t memory_bytes;
  const std::atomic<bool>& decided;  ///< Another strategy has ended the attempt.
};

/// Searches with one strategy. The result is without status, and counts this strategy alone. Any
/// number of threads may do so for the same task.
StrategyEnd RunStrategy(const NamedStrategy& strategy, const ProverTask& task,
                        const StrategyLimits& limits, ProverResult& result);

/// CPU seconds that the calling thread has used.
double ThreadSeconds();

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_STRATEGY_RUN_H_

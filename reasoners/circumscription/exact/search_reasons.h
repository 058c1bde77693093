// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_SEARCH_REASONS_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_SEARCH_REASONS_H_

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "latchwork/sdk/explanation.h"
#include "reasoners/circumscription/engine/engine.h"
#include "reasoners/circumscription/evaluation/evaluator.h"
#include "reasoners/circumscription/exact/ground_store.h"

namespace latchwork::circumscription {

/// Why atoms are false in minimal worlds that a search found. It asks an engine of its own, so that
/// asking changes nothing for later cycles. For reports. Not thread-safe.
class SearchReasons {
 public:
  /// All of them outlive it, as they were in the decision that is asked about.
  SearchReasons(const GroundStore& store, const Evaluator& evaluator,
                std::span<const Literal> latches, const EngineOptions& options);

  /// A minimal world in which `atom` is false, and what each clause that might conclude it lacks
  /// there: where possible, what it lacks in every minimal world. Where others have the atom, the
  /// derivation lists what that world has of its own. Nothing: the atom holds in all, or the search
  /// came to no end.
  std::optional<sdk::Explanation> WhyFalse(Atom atom);

 private:
  std::vector<sdk::NearMiss> MissesIn(const Model& world, Atom atom);
  std::optional<sdk::NearMiss> MissOf(std::size_t clause, const Model& world, Atom atom);
  bool IsEverywhere(Literal literal);
  sdk::Derivation Describe(const Model& world, Atom atom);
  std::string TextOf(Literal literal) const;

  const GroundStore& store_;
  const Evaluator& evaluator_;
  Engine engine_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EXACT_SEARCH_REASONS_H_

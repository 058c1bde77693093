// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PROOF_TREE_H_
#define LATCHWORK_PTTP_PROOF_TREE_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "latchwork/logic/clause.h"
#include "reasoners/pttp/proofs/proof_premise.h"

namespace latchwork::pttp {

/// A goal and how it was shown.
struct ProofNode {
  enum class Kind : std::uint8_t {
    kPremise,    ///< By a premise; the children are what its other literals ask for.
    kReduction,  ///< A goal above is its complement: that one holds, or else this one does.
    kRepeated,   ///< As an earlier node with the same goal was.
  };
  Kind kind = Kind::kPremise;
  logic::Literal goal;
  std::size_t premise = 0;  ///< kPremise: its index.
  std::vector<std::size_t> children;
};

/// A closed connection tableau of premises.
struct ProofTree {
  std::size_t start = 0;              ///< The premise that it begins with.
  std::vector<std::size_t> children;  ///< Nodes; their goals contradict the start's literals.
  std::vector<ProofNode> nodes;
};

/// Arranges premises that contradict each other as a tree that starts from one of `starts`, the
/// first that will do. Variables count as constants. Nothing, when there is no such tree, or when
/// it is not found within a bounded number of steps or would be too deep.
std::optional<ProofTree> ArrangeProof(std::span<const ProofPremise> premises,
                                      std::span<const std::size_t> starts);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PROOF_TREE_H_

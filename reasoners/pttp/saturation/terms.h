// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_TERMS_H_
#define LATCHWORK_PTTP_SATURATION_TERMS_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace latchwork::pttp::saturation {

using TermId = std::uint32_t;
using FunctorId = std::uint32_t;

inline constexpr TermId kVariableBit = 0x80000000U;
inline constexpr TermId kNoTerm = 0x7FFFFFFFU;
/// The constant that every atom is equated with: `p(X)` is the equation `p(X) = $true`.
inline constexpr TermId kTrue = 0;

/// What the orderings and the clause selection know of a function or predicate symbol.
struct Functor {
  /// Constants of one class are pairwise unequal; kObject also differs from every number.
  enum class Distinct : std::uint8_t { kNo, kInteger, kReal, kObject };

  std::uint32_t arity = 0;
  std::uint32_t weight = 1;       ///< In the Knuth-Bendix ordering; 0 for at most one unary one.
  std::uint32_t goal_weight = 2;  ///< In the goal-directed clause weight.
  std::uint32_t precedence = 0;   ///< Unique.
  Distinct distinct = Distinct::kNo;
};

/// Perfectly shared terms: equal terms have equal ids, so equality is one comparison. Variables
/// are ids without a node. Nothing here recurses. One thread.
class Terms {
 public:
  Terms();

  FunctorId AddFunctor(const Functor& functor);
  Functor& functor(FunctorId id) { return functors_[id]; }
  const Functor& functor(FunctorId id) const { return functors_[id]; }
  std::size_t functor_count() const { return functors_.size(); }

  static constexpr TermId Variable(std::uint32_t number) { return number | kVariableBit; }
  static constexpr bool IsVariable(TermId term) { return (term & kVariableBit) != 0; }
  static constexpr std::uint32_t Number(TermId variable) { return variable & ~kVariableBit; }

  /// `arguments` must not point into this object.
  TermId Make(FunctorId functor, std::span<const TermId> arguments);

  FunctorId head(TermId term) const { return nodes_[term].functor; }
  std::span<const TermId> arguments(TermId term) const {
    const Node& node = nodes_[term];
    return {arguments_.data() + node.arguments, functors_[node.functor].arity};
  }
  bool is_ground(TermId term) const { return !IsVariable(term) && nodes_[term].ground; }
  std::uint32_t weight(TermId term) const { return IsVariable(term) ? 1 : nodes_[term].weight; }
  /// Two for each function symbol, one for each variable.
  std::uint32_t size(TermId term) const { return IsVariable(term) ? 1 : nodes_[term].size; }
  std::uint32_t goal_weight(TermId term) const {
    return IsVariable(term) ? kGoalVariable : nodes_[term].goal_weight;
  }
  /// A mark that the rewriter leaves on terms that it found irreducible; 0 in new ones.
  std::uint32_t stamp(TermId term) const { return nodes_[term].stamp; }
  void SetStamp(TermId term, std::uint32_t stamp) { nodes_[term].stamp = stamp; }

  /// Terms made after Mark() are forgotten by Rollback().
  std::size_t Mark() const { return nodes_.size(); }
  void Rollback(std::size_t mark);

  /// Weights of terms made before the functors changed are computed again.
  void Reweigh();
  std::size_t bytes() const;

 private:
  struct Node {
    FunctorId functor;
    std::uint32_t arguments;
    std::uint32_t weight;
    std::uint32_t size;
    std::uint32_t goal_weight;
    std::uint32_t stamp;
    TermId next;
    bool ground;
  };
  static constexpr std::uint32_t kGoalVariable = 2;

  std::size_t Bucket(FunctorId functor, std::span<const TermId> arguments) const;
  void Weigh(Node& node) const;
  void Grow();

  std::vector<Functor> functors_;
  std::vector<Node> nodes_;
  std::vector<TermId> arguments_;
  std::vector<TermId> buckets_;
};

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_TERMS_H_

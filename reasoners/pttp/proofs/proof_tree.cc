// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/proof_tree.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace latchwork::pttp {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kMostSteps = 20'000;
constexpr std::size_t kMostStarts = 8;
constexpr std::size_t kDeepest = 2000;

/// A literal as a number: 2 * atom + positive.
using Number = std::size_t;

Number Complement(Number literal) { return literal ^ 1U; }

/// The premises with their literals numbered.
class Premises {
 public:
  explicit Premises(std::span<const ProofPremise> premises) {
    std::map<logic::Atom, std::size_t> atoms;
    for (const ProofPremise& premise : premises) {
      std::vector<Number>& numbers = numbers_.emplace_back();
      for (const logic::Literal& literal : premise.instance.literals) {
        const auto [place, is_new] = atoms.try_emplace(literal.atom, atoms.size());
        if (is_new) {
          literals_.push_back({false, literal.atom});
          literals_.push_back({true, literal.atom});
        }
        const Number number = 2 * place->second + (literal.positive ? 1U : 0U);
        if (std::ranges::find(numbers, number) == numbers.end()) numbers.push_back(number);
      }
    }
    holders_.resize(literals_.size());
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      for (const Number number : numbers_[i]) holders_[number].push_back(i);
    }
  }

  std::size_t size() const { return numbers_.size(); }
  std::size_t literal_count() const { return literals_.size(); }
  const logic::Literal& literal(Number number) const { return literals_[number]; }
  const std::vector<Number>& of(std::size_t premise) const { return numbers_[premise]; }
  const std::vector<std::size_t>& holders(Number number) const { return holders_[number]; }

 private:
  std::vector<logic::Literal> literals_;
  std::vector<std::vector<Number>> numbers_;       ///< By premise.
  std::vector<std::vector<std::size_t>> holders_;  ///< Premises, by literal.
};

/// What follows from all premises but one by unit propagation, and by which premise: what needs no
/// search, shallowest first.
std::vector<std::size_t> Propagate(const Premises& premises, std::size_t without) {
  std::vector<std::size_t> reasons(premises.literal_count(), kNone);
  std::vector<std::size_t> false_literals(premises.size(), 0);
  std::vector<Number> queue;
  const auto conclude = [&](std::size_t premise) {
    for (const Number number : premises.of(premise)) {
      if (reasons[Complement(number)] != kNone) continue;
      if (reasons[number] == kNone) {
        reasons[number] = premise;
        queue.push_back(number);
      }
      return;
    }
  };
  for (std::size_t i = 0; i < premises.size(); ++i) {
    if (i != without && premises.of(i).size() == 1) conclude(i);
  }
  std::size_t next = 0;
  while (next < queue.size()) {
    for (const std::size_t premise : premises.holders(Complement(queue[next++]))) {
      if (premise == without) continue;
      if (++false_literals[premise] + 1 == premises.of(premise).size()) conclude(premise);
    }
  }
  return reasons;
}

class Arranger {
 public:
  Arranger(const Premises& premises, std::size_t start)
      : premises_(premises),
        start_(start),
        reasons_(Propagate(premises, start)),
        on_path_(premises.literal_count(), false) {}

  std::optional<ProofTree> Arrange() {
    ProofTree tree;
    tree.start = start_;
    for (const Number number : premises_.of(start_)) {
      if (!Show(Complement(number))) return std::nullopt;
      tree.children.push_back(shown_);
    }
    tree.nodes = std::move(nodes_);
    return tree;
  }

 private:
  /// The goals above that a node relies on.
  using Needs = std::set<Number>;

  /// Puts a node for the goal into `shown_`, or leaves everything as it was.
  bool Show(Number goal) {
    if (++steps_ > kMostSteps || depth_ > kDeepest || on_path_[goal]) return false;
    if (const std::size_t reason = reasons_[goal];
        reason != kNone && premises_.of(reason).size() == 1) {
      return Close(goal, ProofNode::Kind::kPremise, reason, {}, {});
    }
    if (on_path_[Complement(goal)]) {
      return Close(goal, ProofNode::Kind::kReduction, 0, {}, {Complement(goal)});
    }
    if (const std::size_t before = Earlier(goal); before != kNone) {
      const Needs needs = needs_[before];
      return Close(goal, ProofNode::Kind::kRepeated, 0, {}, needs);
    }
    if (reasons_[goal] != kNone && Extend(goal, reasons_[goal])) return true;
    return std::ranges::any_of(premises_.holders(goal), [&](std::size_t premise) {
      return premise != reasons_[goal] && Extend(goal, premise);
    });
  }

  bool Extend(Number goal, std::size_t premise) {
    const std::size_t mark = nodes_.size();
    std::vector<std::size_t> children;
    Needs needs;
    on_path_[goal] = true;
    ++depth_;
    const bool done = std::ranges::all_of(premises_.of(premise), [&](Number number) {
      if (number == goal) return true;
      if (!Show(Complement(number))) return false;
      children.push_back(shown_);
      needs.insert(needs_[shown_].begin(), needs_[shown_].end());
      return true;
    });
    --depth_;
    on_path_[goal] = false;
    if (!done) {
      nodes_.resize(mark);
      needs_.resize(mark);
      return false;
    }
    needs.erase(goal);
    return Close(goal, ProofNode::Kind::kPremise, premise, std::move(children), std::move(needs));
  }

  bool Close(Number goal, ProofNode::Kind kind, std::size_t premise,
             std::vector<std::size_t> children, Needs needs) {
    shown_ = nodes_.size();
    if (kind == ProofNode::Kind::kPremise) newest_[goal] = shown_;
    nodes_.push_back({kind, premises_.literal(goal), premise, std::move(children)});
    needs_.push_back(std::move(needs));
    return true;
  }

  /// A node that shows the goal here too.
  std::size_t Earlier(Number goal) const {
    const auto place = newest_.find(goal);
    if (place == newest_.end() || place->second >= nodes_.size()) return kNone;
    const ProofNode& node = nodes_[place->second];
    const Needs& needs = needs_[place->second];
    // Nodes are taken back with what failed, and others come into their place.
    const bool is_it =
        node.kind == ProofNode::Kind::kPremise && node.goal == premises_.literal(goal);
    const bool holds = std::ranges::all_of(needs, [&](Number number) { return on_path_[number]; });
    return is_it && holds ? place->second : kNone;
  }

  const Premises& premises_;
  std::size_t start_;
  std::vector<std::size_t> reasons_;  ///< By literal.
  std::vector<bool> on_path_;         ///< By literal.
  std::vector<ProofNode> nodes_;
  std::vector<Needs> needs_;  ///< By node.
  std::map<Number, std::size_t> newest_;
  std::size_t shown_ = 0;
  std::size_t steps_ = 0;
  std::size_t depth_ = 0;
};

}  // namespace

std::optional<ProofTree> ArrangeProof(std::span<const ProofPremise> premises,
                                      std::span<const std::size_t> starts) {
  const Premises numbered(premises);
  for (const std::size_t start : starts.first(std::min(starts.size(), kMostStarts))) {
    if (auto tree = Arranger(numbered, start).Arrange()) return tree;
  }
  return std::nullopt;
}

}  // namespace latchwork::pttp

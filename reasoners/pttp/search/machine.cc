// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/search/machine.h"

#include <algorithm>

namespace latchwork::pttp {
namespace {

constexpr std::size_t kMostHeapWords = std::size_t{1} << 26U;
constexpr std::size_t kMostChoices = std::size_t{1} << 21U;
constexpr std::size_t kMostCachedWords = std::size_t{1} << 26U;

bool IsAtomic(Word word) {
  const Tag tag = TagOf(Dereference(word));
  return tag != Tag::kReference && tag != Tag::kCompound;
}

}  // namespace

Machine::Machine(const Workshop& workshop)
    : shop_(workshop), unifier_(*workshop.heap), calculator_(*workshop.functors, *workshop.heap) {}

SearchEnd Machine::Search(const SearchRequest& request, ProofSink& sink) {
  reach_ = request.reach;
  situations_ = request.situations;
  record_ = request.record;
  floundered_ = undetermined_ = false;
  unifier_.ForgetTrail();
  const Arena::Mark mark = shop_.heap->mark();
  const std::uint32_t deepest = std::max(1U, request.depth);
  SearchEnd end = SearchEnd::kExhausted;
  for (std::uint32_t depth = reach_->recursive ? 1 : deepest; depth <= deepest; ++depth) {
    BeginLevel(depth);
    for (const Contrapositive* start : request.starts) {
      end = RunStart(*start, sink);
      shop_.heap->Release(mark);
      if (end != SearchEnd::kExhausted) return end;
    }
    if (!LevelIsComplete()) continue;
    if (all_chosen_ != 0) return SearchEnd::kDoubtful;
    if (floundered_ || undetermined_) return SearchEnd::kUndetermined;
    shop_.failures->Settle(level_);
    return SearchEnd::kExhausted;
  }
  return all_chosen_ != 0 ? SearchEnd::kDoubtful : SearchEnd::kDepth;
}

bool Machine::LevelIsComplete() const {
  // Without recursion no goal is deeper than the theory is high; then the bound cut nothing, here
  // or wherever a failure was remembered.
  if (!reach_->recursive && reach_->height < level_depth_) return true;
  return !cut_ && std::all_of(cut_goals_.begin(), cut_goals_.end(), [&](std::uint32_t entry) {
    return shop_.failures->IsBarren(entry, level_);
  });
}

SearchEnd Machine::RunStart(const Contrapositive& start, ProofSink& sink) {
  Begin(start);
  const auto end = [&](SearchEnd result) {
    unifier_.UndoTo(0);
    return result;
  };
  bool forward = true;
  for (;;) {
    if (shop_.meter->stopped()) return end(SearchEnd::kStopped);
    if (!forward) {
      if (choices_.empty()) return end(SearchEnd::kExhausted);
      forward = Resume();
      continue;
    }
    switch (Select()) {
      case Selection::kGoal:
        forward = Call();
        break;
      case Selection::kStuck:
        floundered_ = true;
        floundered_predicate_ = delayed_->literal->predicate;
        forward = false;
        break;
      case Selection::kProof: {
        if (all_chosen_ != chosen_) return end(SearchEnd::kDoubtful);
        const Activation& root = *continuation_.activation;
        if (sink.Accept({root.rule, root.slots, resting_, steps_, depth_})) {
          return end(SearchEnd::kAccepted);
        }
        forward = false;
        break;
      }
    }
  }
}

Node* Machine::MakeNode() {
  const CompiledLiteral& literal = *selected_.literal;
  const Activation& activation = *selected_.activation;
  Word* arguments = shop_.heap->Allocate(literal.arity);
  for (std::uint32_t i = 0; i < literal.arity; ++i) {
    arguments[i] = unifier_.Build(literal.arguments[i], activation.slots);
    if (literal.arithmetic == 0 || (i < 64 && ((literal.arithmetic >> i) & 1U) == 0)) continue;
    if (!unifier_.IsGround(arguments[i])) continue;
    const auto value = calculator_.Normalize(arguments[i]);
    if (!value) return nullptr;
    arguments[i] = *value;
  }
  return shop_.heap->Make(
      Node{&literal, arguments, activation.node, activation.remaining, 0, false});
}

bool Machine::Call() {
  shop_.meter->CountWork();
  CheckMemory();
  Node* node = MakeNode();
  if (node == nullptr) return false;
  if ((*shop_.predicates)[node->literal->predicate].kind == PredicateKind::kArithmetic) {
    return CallArithmetic(*node);
  }
  return CallOrdinary(*node);
}

bool Machine::CallArithmetic(const Node& node) {
  const auto truth = Calculator::Decide((*shop_.predicates)[node.literal->predicate].arithmetic,
                                        node.arguments, node.literal->arity);
  if (!truth || *truth != node.literal->positive) return false;
  Record({.kind = Step::Kind::kArithmetic, .node = &node});
  return true;
}

bool Machine::CallOrdinary(Node& node) {
  const CompiledLiteral& literal = *node.literal;
  const std::uint32_t key = Signed(literal.predicate, literal.positive);
  std::uint32_t entry = kNoEntry;
  if (!reach_->reduction_free && RepeatsAncestor(node)) return false;
  if (reach_->reduction_free && HasRules(literal)) {
    const std::uint64_t label = (std::uint64_t{key} << 2U) | (situations_ != nullptr ? 2U : 0U) |
                                (reach_->closing ? 1U : 0U);
    const auto found = shop_.failures->Enter(label, {node.arguments, literal.arity});
    node.ground = found.ground;
    entry = found.entry;
    if (entry != kNoEntry && shop_.failures->FailsWithin(entry, node.remaining)) {
      if (!shop_.failures->FailsAlways(entry)) NoteCut(entry);
      return false;
    }
  } else {
    node.ground = std::all_of(node.arguments, node.arguments + literal.arity, IsAtomic);
  }
  node.choice = static_cast<std::uint32_t>(choices_.size());
  Choice choice{};
  choice.heap = shop_.heap->mark();
  choice.trail = unifier_.trail_size();
  choice.continuation = continuation_;
  choice.delayed = delayed_;
  choice.resting = resting_;
  choice.steps = steps_;
  choice.node = &node;
  choice.ancestor = node.parent;
  choice.entry = entry;
  choice.depth = depth_;
  choice.chosen = chosen_;
  choice.all_chosen = all_chosen_;
  choice.cacheable = delayed_ == nullptr;
  choices_.push_back(choice);
  return Proceed();
}

bool Machine::RepeatsAncestor(const Node& node) {
  for (const Node* ancestor = node.parent; ancestor != nullptr; ancestor = ancestor->parent) {
    if (ancestor->literal->predicate != node.literal->predicate ||
        ancestor->literal->positive != node.literal->positive) {
      continue;
    }
    std::uint32_t same = 0;
    while (same < node.literal->arity &&
           unifier_.Identical(ancestor->arguments[same], node.arguments[same])) {
      ++same;
    }
    if (same == node.literal->arity) return true;
  }
  return false;
}

bool Machine::Resume() {
  const Choice& choice = choices_.back();
  Retreat(choice);
  continuation_ = choice.continuation;
  delayed_ = choice.delayed;
  resting_ = choice.resting;
  steps_ = choice.steps;
  depth_ = choice.depth;
  chosen_ = choice.chosen;
  return Proceed();
}

bool Machine::Proceed() {
  Choice& choice = choices_.back();
  while (choice.phase != Phase::kDone) {
    if (TryPhase(choice)) return true;
    if (unifier_.exhausted()) {
      unifier_.ClearExhausted();
      shop_.meter->Stop(sdk::Limit::kInferences);
    }
    if (shop_.meter->stopped()) return false;
    choice.phase = static_cast<Phase>(static_cast<int>(choice.phase) + 1);
  }
  Fail(choice);
  return false;
}

bool Machine::TryPhase(Choice& choice) {
  switch (choice.phase) {
    case Phase::kEquality:
      return TryEquality(choice);
    case Phase::kReduction:
      return TryReduction(choice);
    case Phase::kSituations:
      return TrySituations(choice);
    case Phase::kFacts:
      return TryFacts(choice);
    case Phase::kComputed:
      return TryComputed(choice);
    case Phase::kRules:
      return TryRules(choice);
    case Phase::kClosing:
      return TryClosing(choice);
    case Phase::kDone:
      break;
  }
  return false;
}

void Machine::Retreat(const Choice& choice) {
  unifier_.UndoTo(choice.trail);
  shop_.heap->Release(choice.heap);
}

void Machine::Fail(Choice& choice) {
  const bool certain = !choice.proved && choice.cacheable && !undetermined_ && !floundered_ &&
                       choice.all_chosen == all_chosen_;
  if (choice.entry != kNoEntry && certain) {
    shop_.failures->MarkFailed(choice.entry, choice.node->remaining, !choice.cut, level_);
  }
  choices_.pop_back();
}

void Machine::NoteCut(std::uint32_t entry) {
  if (entry == kNoEntry) {
    cut_ = true;
  } else if (shop_.failures->MarkCut(entry, level_)) {
    cut_goals_.push_back(entry);
  }
}

void Machine::CheckMemory() {
  if (shop_.heap->reserved_words() > kMostHeapWords || choices_.size() > kMostChoices ||
      shop_.failures->words() > kMostCachedWords) {
    shop_.meter->Stop(sdk::Limit::kInferences);
  }
}

void Machine::Record(const Step& step) {
  if (!record_) return;
  Step* kept = shop_.heap->Make(step);
  kept->previous = steps_;
  steps_ = kept;
}

void Machine::RestOn(std::size_t assumption) {
  resting_ = shop_.heap->Make(Resting{resting_, assumption});
}

bool Machine::SolvedAtOnce(Choice& choice, const Step& step) {
  shop_.meter->CountInference();
  Record(step);
  choice.proved = true;
  if (choice.entry != kNoEntry) shop_.failures->MarkProved(choice.entry, level_);
  // When nothing above was bound, no other solution is more general.
  const bool most_general = unifier_.trail_size() == choice.trail ||
                            (choice.node->ground && step.kind != Step::Kind::kReduction);
  if (most_general && step.kind != Step::Kind::kAttachment) choices_.pop_back();
  return true;
}

}  // namespace latchwork::pttp

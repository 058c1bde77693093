// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/plans/situations.h"

#include <algorithm>

namespace latchwork::pttp {

void Situations::Clear() {
  ground_.Clear();
  origins_.clear();
  question_numbers_.Clear();
  asked_ = 0;
  situations_.clear();
  states_.clear();
}

std::uint32_t Situations::NumberOfOrigin(Word situation) {
  for (std::uint32_t i = 0; i < origins_.size(); ++i) {
    if (SameAtomic(origins_[i].situation, situation)) return i;
  }
  origins_.push_back({ground_.Copy(situation), kNoState, {}});
  return static_cast<std::uint32_t>(origins_.size() - 1);
}

void Situations::AddInitially(Word situation, std::uint32_t atom) {
  origins_[NumberOfOrigin(situation)].atoms.push_back(atom);
}

void Situations::Begin() {
  graph_.Begin();
  if (origins_.empty()) {
    // What needs no beginning holds after any.
    Word* any = ground_.terms().Allocate(1);
    *any = Reference(any);
    origins_.push_back({*any, kNoState, {}});
  }
  for (Origin& origin : origins_) {
    origin.state = graph_.AddRoot(origin.atoms);
    situations_.resize(graph_.size(), 0);
    if (situations_[origin.state] == 0) situations_[origin.state] = origin.situation;
  }
}

std::uint32_t Situations::Ask(PredicateId fluent, std::span<const Word> arguments) {
  const auto found = question_numbers_.Enter(fluent, arguments);
  if (!found.added) return found.entry;
  if (asked_ == questions_.size()) questions_.emplace_back();
  Question& question = questions_[asked_++];
  question.answers.clear();
  question.next_state = 0;
  MatchAtoms(fluent, arguments, question);
  return found.entry;
}

void Situations::MatchAtoms(PredicateId fluent, std::span<const Word> arguments,
                            Question& question) {
  question.atoms.clear();
  matcher_.ForgetTrail();
  for (const std::uint32_t atom : ground_.AtomsOf(fluent)) {
    const Word* known = ground_.atom(atom).arguments;
    bool same = true;
    for (std::size_t i = 0; same && i < arguments.size(); ++i) {
      same = matcher_.Unify(arguments[i], known[i]);
    }
    matcher_.UndoTo(0);
    if (same) question.atoms.push_back(atom);
  }
}

Situations::Answer Situations::Find(std::uint32_t question, std::uint32_t index,
                                    std::uint32_t limit, Meter& meter, Instance& instance) {
  Question& asked = questions_[question];
  if (asked.atoms.empty()) return Answer::kNone;
  while (asked.answers.size() <= index) {
    const std::uint32_t state = asked.next_state;
    while (state == graph_.size()) {
      if (!graph_.Grow(meter)) return Answer::kNone;
    }
    if (graph_.LengthOf(state) >= limit) return Answer::kTooFar;
    ++asked.next_state;
    for (const std::uint32_t atom : asked.atoms) {
      if (graph_.Holds(state, atom)) asked.answers.push_back({state, atom});
    }
  }
  instance = asked.answers[index];
  return graph_.LengthOf(instance.state) < limit ? Answer::kFound : Answer::kTooFar;
}

bool Situations::FindIn(std::uint32_t state, std::uint32_t question, std::uint32_t& place,
                        Instance& instance) const {
  const std::vector<std::uint32_t>& atoms = questions_[question].atoms;
  while (place < atoms.size()) {
    const std::uint32_t atom = atoms[place++];
    if (!graph_.Holds(state, atom)) continue;
    instance = {state, atom};
    return true;
  }
  return false;
}

std::uint32_t Situations::StateOf(Word situation) const {
  const auto known = states_.find(situation);
  if (known != states_.end()) return known->second;
  for (const Origin& origin : origins_) {
    if (SameAtomic(origin.situation, situation)) return origin.state;
  }
  return kNoState;
}

Word Situations::SituationOf(std::uint32_t state) {
  situations_.resize(graph_.size(), 0);
  std::vector<std::uint32_t> way;
  for (; situations_[state] == 0; state = graph_.ParentOf(state)) way.push_back(state);
  Word situation = situations_[state];
  while (!way.empty()) {
    state = way.back();
    way.pop_back();
    const GroundRules::Action& action = ground_.action(graph_.ActionOf(state));
    const std::size_t arity = ArityOf(action.header);
    const std::uint32_t hole = rules_->HoleOf(action.header).value_or(0);
    Word* block = ground_.terms().Allocate(arity + 1);
    block[0] = action.header;
    for (std::size_t i = 0, next = 0; i < arity; ++i) {
      block[i + 1] = i == hole ? situation : action.arguments[next++];
    }
    situation = situations_[state] = Tagged(Tag::kCompound, block);
    states_.emplace(situation, state);
  }
  return situation;
}

bool Situations::Fires(const GroundRule& rule, std::uint32_t state) const {
  const std::uint32_t parent = graph_.ParentOf(state);
  const auto body = ground_.BodyOf(rule);
  switch (rule.kind) {
    case FluentRule::Kind::kInitial:
      return parent == kNoState && origins_[rule.action].state == state;
    case FluentRule::Kind::kWithin:
      return graph_.HoldAll(state, body);
    case FluentRule::Kind::kSuccessor:
      break;
  }
  return parent != kNoState && graph_.HoldAll(parent, body) &&
         graph_.SpeaksOf(rule.action, graph_.ActionOf(state));
}

/// Rules within a situation may need each other's conclusions in a circle, so all of them count.
void Situations::Support(Instance instance) {
  bool supported = false;
  for (const GroundRule& rule : ground_.rules()) {
    const bool within = rule.kind == FluentRule::Kind::kWithin;
    if (rule.head != instance.atom || (supported && !within)) continue;
    if (!Fires(rule, instance.state)) continue;
    supported = supported || !within;
    const auto assumptions = ground_.AssumptionsOf(rule);
    assumptions_.insert(assumptions_.end(), assumptions.begin(), assumptions.end());
    const std::uint32_t before = within ? instance.state : graph_.ParentOf(instance.state);
    for (const std::uint32_t atom : ground_.BodyOf(rule)) {
      const bool known = std::any_of(
          supporting_.begin(), supporting_.end(),
          [&](const Instance& other) { return other.state == before && other.atom == atom; });
      if (!known) supporting_.push_back({before, atom});
    }
  }
}

std::span<const std::size_t> Situations::AssumptionsOf(const Instance& instance) {
  assumptions_.clear();
  if (!ground_.assumes()) return assumptions_;
  supporting_.assign(1, instance);
  for (std::size_t done = 0; done < supporting_.size();) Support(supporting_[done++]);
  std::sort(assumptions_.begin(), assumptions_.end());
  assumptions_.erase(std::unique(assumptions_.begin(), assumptions_.end()), assumptions_.end());
  return assumptions_;
}

}  // namespace latchwork::pttp

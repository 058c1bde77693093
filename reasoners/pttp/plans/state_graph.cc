// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/plans/state_graph.h"

#include <algorithm>
#include <bit>

namespace latchwork::pttp {

void StateGraph::Begin() {
  words_ = (rules_->atoms() + 63) / 64;
  bits_.clear();
  states_.clear();
  known_.Clear();
  next_ = 0;
  SortRules();
  MakeKept();
  successor_.assign(words_, 0);
  last_heads_.assign(rules_->actions(), kNoState);
}

/// Stable: rules of one list keep their order.
template <typename Index>
void StateGraph::Sort(Lists& lists, std::size_t count, std::span<const std::uint32_t> rules,
                      Index&& index) {
  lists.first.assign(count + 1, 0);
  lists.rules.resize(rules.size());
  for (const std::uint32_t rule : rules) ++lists.first[index(rule) + 1];
  for (std::size_t i = 1; i <= count; ++i) lists.first[i] += lists.first[i - 1];
  std::vector<std::uint32_t> place(lists.first.begin(), lists.first.end() - 1);
  for (const std::uint32_t rule : rules) lists.rules[place[index(rule)]++] = rule;
}

void StateGraph::SortRules() {
  const auto& rules = rules_->rules();
  within_.clear();
  unconditional_.clear();
  std::vector<std::uint32_t> effects;
  std::vector<std::uint32_t> frames;
  for (std::uint32_t i = 0; i < rules.size(); ++i) {
    const GroundRule& rule = rules[i];
    if (rule.kind == FluentRule::Kind::kWithin) {
      within_.push_back(i);
    } else if (rule.kind == FluentRule::Kind::kSuccessor && rule.frame) {
      if (rule.size > 1) frames.push_back(i);
    } else if (rule.kind == FluentRule::Kind::kSuccessor) {
      (rule.size == 0 ? unconditional_ : effects).push_back(i);
    }
  }
  SortEffects(effects);
  Sort(frames_, rules_->actions(), frames, [&](std::uint32_t rule) { return rules[rule].action; });
}

/// An effect is looked at when the rarest of its atoms holds.
void StateGraph::SortEffects(std::span<const std::uint32_t> effects) {
  const auto& rules = rules_->rules();
  needs_.assign(rules_->atoms(), 0);
  for (const std::uint32_t effect : effects) {
    for (const std::uint32_t atom : rules_->BodyOf(rules[effect])) ++needs_[atom];
  }
  Sort(effects_, rules_->atoms(), effects, [&](std::uint32_t effect) {
    const auto body = rules_->BodyOf(rules[effect]);
    return *std::min_element(body.begin(), body.end(), [&](std::uint32_t a, std::uint32_t b) {
      return needs_[a] < needs_[b];
    });
  });
}

void StateGraph::MakeKept() {
  const auto actions = static_cast<std::uint32_t>(rules_->actions());
  std::vector<bool> has_effect(actions, false);
  for (const GroundRule& rule : rules_->rules()) {
    if (rule.kind == FluentRule::Kind::kSuccessor && !rule.frame) has_effect[rule.action] = true;
  }
  kept_.assign(actions * words_, 0);
  for (const GroundRule& rule : rules_->rules()) {
    if (rule.kind != FluentRule::Kind::kSuccessor || !rule.frame || rule.size != 1) continue;
    Set(kept_.data() + rule.action * words_, rule.head);
  }
  std::vector<std::uint32_t> open;
  for (std::uint32_t action = 0; action < actions; ++action) {
    if (!rules_->action(action).ground) open.push_back(action);
  }
  patterns_.first.assign(1, 0);
  patterns_.rules.clear();
  for (std::uint32_t action = 0; action < actions; ++action) {
    for (const std::uint32_t spoken : open) {
      if (has_effect[action] && SpeaksOf(spoken, action)) AddKept(action, spoken);
    }
    patterns_.first.push_back(static_cast<std::uint32_t>(patterns_.rules.size()));
  }
}

void StateGraph::AddKept(std::uint32_t action, std::uint32_t spoken) {
  for (std::size_t i = 0; i < words_; ++i) {
    kept_[action * words_ + i] |= kept_[spoken * words_ + i];
  }
  patterns_.rules.push_back(spoken);
}

std::uint32_t StateGraph::AddRoot(std::span<const std::uint32_t> atoms) {
  std::fill(successor_.begin(), successor_.end(), 0);
  for (const std::uint32_t atom : atoms) Set(successor_.data(), atom);
  CloseWithin(successor_.data());
  return Enter({kNoState, kNoAction, 0});
}

bool StateGraph::Grow(Meter& meter) {
  if (next_ == states_.size() || meter.stopped()) return false;
  const auto state = static_cast<std::uint32_t>(next_++);
  FindEffects(state, meter);
  for (const std::uint32_t action : tried_) Follow(state, action);
  if (bits_.size() > kMostWords) meter.Stop(sdk::Limit::kInferences);
  return true;
}

void StateGraph::FindEffects(std::uint32_t state, Meter& meter) {
  const auto& rules = rules_->rules();
  tried_.clear();
  heads_.clear();
  for (const std::uint32_t effect : unconditional_) Trigger(effect);
  const std::uint64_t* bits = BitsOf(state);
  for (std::uint32_t word = 0; word < words_; ++word) {
    for (std::uint64_t left = bits[word]; left != 0; left &= left - 1) {
      const auto atom = 64 * word + static_cast<std::uint32_t>(std::countr_zero(left));
      for (const std::uint32_t effect : effects_.of(atom)) {
        meter.CountWork();
        if (!Hold(bits, rules_->BodyOf(rules[effect]))) continue;
        meter.CountInference();
        Trigger(effect);
      }
    }
  }
}

void StateGraph::Trigger(std::uint32_t rule) {
  const GroundRule& effect = rules_->rules()[rule];
  std::uint32_t& last = last_heads_[effect.action];
  if (last == kNoState) tried_.push_back(effect.action);
  heads_.push_back({effect.head, last});
  last = static_cast<std::uint32_t>(heads_.size() - 1);
}

void StateGraph::Follow(std::uint32_t state, std::uint32_t action) {
  const std::uint64_t* bits = BitsOf(state);
  const std::uint64_t* kept = kept_.data() + action * words_;
  for (std::size_t i = 0; i < words_; ++i) successor_[i] = bits[i] & kept[i];
  for (std::uint32_t head = last_heads_[action]; head != kNoState; head = heads_[head].next) {
    Set(successor_.data(), heads_[head].atom);
  }
  last_heads_[action] = kNoState;
  const auto keep = [&](std::uint32_t spoken) {
    for (const std::uint32_t frame : frames_.of(spoken)) {
      const GroundRule& rule = rules_->rules()[frame];
      if (Hold(bits, rules_->BodyOf(rule))) Set(successor_.data(), rule.head);
    }
  };
  keep(action);
  for (const std::uint32_t spoken : patterns_.of(action)) keep(spoken);
  CloseWithin(successor_.data());
  bool gains = false;
  for (std::size_t i = 0; i < words_; ++i) gains = gains || (successor_[i] & ~bits[i]) != 0;
  if (gains) Enter({state, action, states_[state].length + 1});
}

void StateGraph::CloseWithin(std::uint64_t* bits) {
  for (bool changed = !within_.empty(); changed;) {
    changed = false;
    for (const std::uint32_t index : within_) {
      const GroundRule& rule = rules_->rules()[index];
      if (((bits[rule.head / 64] >> (rule.head % 64)) & 1U) != 0) continue;
      if (!Hold(bits, rules_->BodyOf(rule))) continue;
      Set(bits, rule.head);
      changed = true;
    }
  }
}

std::uint32_t StateGraph::Enter(const State& state) {
  std::uint64_t hash = 0;
  for (const std::uint64_t word : successor_) hash = MixHash(hash, word);
  const auto fresh = static_cast<std::uint32_t>(states_.size());
  const std::uint32_t number = known_.Enter(hash, fresh, [&](std::uint32_t known) {
    return std::equal(successor_.begin(), successor_.end(), BitsOf(known));
  });
  if (number != fresh) return number;
  states_.push_back(state);
  bits_.insert(bits_.end(), successor_.begin(), successor_.end());
  return number;
}

}  // namespace latchwork::pttp

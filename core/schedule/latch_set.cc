// SPDX-License-Identifier: BSD-3-Clause
#include "core/schedule/latch_set.h"

#include <algorithm>
#include <utility>

#include "core/schedule/contain.h"

namespace latchwork::schedule {

void Settlement::Clear() {
  changes.clear();
  refused.clear();
  problems.clear();
}

LatchSet::LatchSet(const std::vector<Input>& inputs, logic::SymbolTable& symbols) {
  for (const Input& input : inputs) {
    slots_.emplace_back(input, symbols);
    latches_.push_back({input.port.name, {}, 0});
  }
}

const logic::Fact& LatchSet::Content::At(std::size_t index) const {
  return index < facts.size() ? facts[index] : undecided.facts[index - facts.size()];
}

void LatchSet::Content::Drop(std::span<const std::size_t> indices) {
  const auto split = std::lower_bound(indices.begin(), indices.end(), facts.size());
  std::vector<std::size_t> of_undecided(split, indices.end());
  for (std::size_t& index : of_undecided) index -= facts.size();
  std::size_t next = 0;
  std::erase_if(facts, [&](const logic::Fact&) {
    return std::binary_search(indices.begin(), split, next++);
  });
  undecided.Drop(of_undecided);
}

void LatchSet::Content::Swap(sdk::Latch& latch) {
  facts.swap(latch.facts);
  std::swap(undecided, latch.undecided);
}

void LatchSet::Offer(std::size_t port, const sdk::Batch& batch, std::uint64_t tick) {
  Slot& slot = slots_[port];
  slot.arriving.facts.clear();
  std::copy_if(batch.facts.begin(), batch.facts.end(), std::back_inserter(slot.arriving.facts),
               [&](const logic::Fact& fact) { return slot.contract.Declares(fact); });
  slot.arriving.undecided.Clear();
  if (!batch.undecided.facts.empty()) {
    slot.arriving.undecided = batch.undecided;
    indices_.clear();
    for (std::size_t i = 0; i < batch.undecided.facts.size(); ++i) {
      if (!slot.contract.Declares(batch.undecided.facts[i])) indices_.push_back(i);
    }
    slot.arriving.undecided.Drop(indices_);
  }
  slot.arrived = true;
  slot.arrival = tick;
}

void LatchSet::Settle(std::uint64_t tick, sdk::Reasoner& reasoner, const sdk::Budget& budget,
                      Settlement& result) {
  result.Clear();
  for (std::size_t port = 0; port < slots_.size(); ++port) TakeBatch(port, tick, result);
  const bool sensors_due = MarkSensors();
  const bool inputs_due = std::any_of(slots_.begin(), slots_.end(), [](const Slot& slot) {
    return !slot.from_sensor && (slot.changed || slot.context == kNever);
  });
  Hide(sensors_due || inputs_due);
  for (std::size_t port = 0; port < slots_.size(); ++port) {
    if (slots_[port].from_sensor && slots_[port].due) Admit(port, reasoner, budget, result);
  }
  if (!sensors_due && !inputs_due) return;
  for (std::size_t port = 0; port < slots_.size(); ++port) {
    Slot& slot = slots_[port];
    if (slot.from_sensor) continue;
    slot.due = slot.changed || slot.context != ContextOf(port);
    if (slot.due) {
      Admit(port, reasoner, budget, result);
    } else {
      ShowAgain(port);
    }
  }
}

/// The batch that arrived, without what breaks the contract, becomes the one to be checked; an old
/// one that nobody renewed is emptied.
void LatchSet::TakeBatch(std::size_t port, std::uint64_t tick, Settlement& result) {
  Slot& slot = slots_[port];
  if (slot.arrived) {
    RefuseOffences(port, result);
    slot.changed = slot.changed || slot.arriving != slot.batch;
    std::swap(slot.batch, slot.arriving);
  }
  slot.stale = slot.stale_after && tick - slot.arrival >= *slot.stale_after &&
               tick > slot.arrival && !slot.batch.empty();
  if (!slot.stale) return;
  slot.batch.facts.clear();
  slot.batch.undecided.Clear();
  slot.changed = true;
}

void LatchSet::RefuseOffences(std::size_t port, Settlement& result) {
  Slot& slot = slots_[port];
  indices_.clear();
  const std::size_t size = slot.arriving.facts.size() + slot.arriving.undecided.facts.size();
  for (std::size_t i = 0; i < size; ++i) {
    std::string offence = slot.contract.Offence(slot.arriving.At(i));
    if (offence.empty()) continue;
    result.refused.push_back({port, slot.arriving.At(i), std::move(offence)});
    indices_.push_back(i);
  }
  if (!indices_.empty()) slot.arriving.Drop(indices_);
}

/// A sensor batch is checked when it differs from the one before, when its last check failed, or
/// when it came again and the other sensors said something new meanwhile. Otherwise it stands.
bool LatchSet::MarkSensors() {
  const auto changing = std::count_if(slots_.begin(), slots_.end(), [](const Slot& slot) {
    return slot.from_sensor && slot.changed;
  });
  bool any = false;
  for (std::size_t port = 0; port < slots_.size(); ++port) {
    Slot& slot = slots_[port];
    const bool again = slot.arrived && (changing > 0 || slot.context != ContextOf(port));
    const bool unchecked = slot.context == kNever && !slot.batch.empty();
    slot.due = slot.from_sensor && (slot.changed || unchecked || again);
    slot.arrived = false;
    any = any || slot.due;
  }
  return any;
}

/// A reasoner that tells latches by their versions must not take a hidden one for what it was. A
/// sensor that says the same again may as well be seen.
void LatchSet::Hide(bool inputs) {
  for (std::size_t port = 0; port < slots_.size(); ++port) {
    Slot& slot = slots_[port];
    if (!(slot.from_sensor ? slot.due : inputs)) continue;
    slot.content.Swap(latches_[port]);
    latches_[port].facts.clear();
    latches_[port].undecided.Clear();
    if (!slot.from_sensor || slot.changed) latches_[port].version = kHidden;
  }
}

void LatchSet::ShowAgain(std::size_t port) {
  slots_[port].content.Swap(latches_[port]);
  latches_[port].version = slots_[port].version;
}

void LatchSet::Admit(std::size_t port, sdk::Reasoner& reasoner, const sdk::Budget& budget,
                     Settlement& result) {
  Slot& slot = slots_[port];
  refusals_.clear();
  indices_.clear();
  slot.context = ContextOf(port);
  if (!slot.batch.empty()) {
    if (const auto problem = Contain([&] { Check(port, reasoner, budget); })) {
      result.problems.push_back(*problem);
      slot.context = kNever;
      refusals_.clear();
      for (std::size_t i = 0; i < slot.batch.facts.size() + slot.batch.undecided.facts.size();
           ++i) {
        refusals_.push_back({i, "its check failed: " + *problem});
      }
    }
  }
  for (const sdk::Refusal& each : refusals_) indices_.push_back(each.index);
  std::sort(indices_.begin(), indices_.end());
  if (slot.changed || indices_ != slot.refused) Report(port, refusals_, result);
  slot.refused = indices_;
  Enter(port, indices_, result);
  slot.changed = false;
}

/// Undecided facts need not agree with each other, only with the others.
void LatchSet::Check(std::size_t port, sdk::Reasoner& reasoner, const sdk::Budget& budget) {
  const Content& batch = slots_[port].batch;
  if (!batch.facts.empty()) reasoner.Admit(latches_, port, batch.facts, budget, refusals_);
  std::erase_if(refusals_,
                [&](const sdk::Refusal& each) { return each.index >= batch.facts.size(); });
  if (batch.undecided.facts.empty()) return;
  trial_ = batch.facts;
  const std::size_t last = trial_.size();
  for (std::size_t i = 0; i < batch.undecided.facts.size(); ++i) {
    trial_.push_back(batch.undecided.facts[i]);
    found_.clear();
    reasoner.Admit(latches_, port, trial_, budget, found_);
    trial_.pop_back();
    for (sdk::Refusal& each : found_) {
      if (each.index == last) refusals_.push_back({last + i, std::move(each.reason)});
    }
  }
}

void LatchSet::Report(std::size_t port, const std::vector<sdk::Refusal>& refused,
                      Settlement& result) {
  for (const sdk::Refusal& each : refused) {
    result.refused.push_back({port, slots_[port].batch.At(each.index), each.reason});
  }
}

void LatchSet::Enter(std::size_t port, const std::vector<std::size_t>& refused,
                     Settlement& result) {
  Slot& slot = slots_[port];
  entering_ = slot.batch;
  if (!refused.empty()) entering_.Drop(refused);
  if (entering_ == slot.content) return ShowAgain(port);
  entering_.Swap(latches_[port]);
  latches_[port].version = ++slot.version;
  result.changes.push_back({port, slot.stale});
}

/// Versions only grow, so their sum names what a batch of this port is checked against.
std::uint64_t LatchSet::ContextOf(std::size_t port) const {
  std::uint64_t sum = 0;
  for (std::size_t other = 0; other < slots_.size(); ++other) {
    const bool before = slots_[other].from_sensor || (!slots_[port].from_sensor && other < port);
    if (other != port && before) sum += slots_[other].version;
  }
  return sum;
}

}  // namespace latchwork::schedule

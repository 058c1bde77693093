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

void LatchSet::Offer(std::size_t port, std::span<const logic::Fact> batch, std::uint64_t tick) {
  Slot& slot = slots_[port];
  slot.arriving.clear();
  std::copy_if(batch.begin(), batch.end(), std::back_inserter(slot.arriving),
               [&](const logic::Fact& fact) { return slot.contract.Declares(fact); });
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
      latches_[port].facts.swap(slot.content);
    }
  }
}

/// The batch that arrived, without what breaks the contract, becomes the one to be checked; an old
/// one that nobody renewed is emptied.
void LatchSet::TakeBatch(std::size_t port, std::uint64_t tick, Settlement& result) {
  Slot& slot = slots_[port];
  if (slot.arrived) {
    std::erase_if(slot.arriving, [&](const logic::Fact& fact) {
      std::string offence = slot.contract.Offence(fact);
      if (offence.empty()) return false;
      result.refused.push_back({port, fact, std::move(offence)});
      return true;
    });
    slot.changed = slot.changed || slot.arriving != slot.batch;
    slot.batch.swap(slot.arriving);
  }
  slot.stale = slot.stale_after && tick - slot.arrival >= *slot.stale_after &&
               tick > slot.arrival && !slot.batch.empty();
  if (!slot.stale) return;
  slot.batch.clear();
  slot.changed = true;
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

void LatchSet::Hide(bool inputs) {
  for (std::size_t port = 0; port < slots_.size(); ++port) {
    Slot& slot = slots_[port];
    if (!(slot.from_sensor ? slot.due : inputs)) continue;
    slot.content.swap(latches_[port].facts);
    latches_[port].facts.clear();
  }
}

void LatchSet::Admit(std::size_t port, sdk::Reasoner& reasoner, const sdk::Budget& budget,
                     Settlement& result) {
  Slot& slot = slots_[port];
  refusals_.clear();
  indices_.clear();
  slot.context = ContextOf(port);
  if (!slot.batch.empty()) {
    const auto problem =
        Contain([&] { reasoner.Admit(latches_, port, slot.batch, budget, refusals_); });
    if (problem) {
      result.problems.push_back(*problem);
      slot.context = kNever;
      refusals_.clear();
      for (std::size_t i = 0; i < slot.batch.size(); ++i) {
        refusals_.push_back({i, "its check failed: " + *problem});
      }
    }
  }
  std::erase_if(refusals_,
                [&](const sdk::Refusal& each) { return each.index >= slot.batch.size(); });
  for (const sdk::Refusal& each : refusals_) indices_.push_back(each.index);
  std::sort(indices_.begin(), indices_.end());
  if (slot.changed || indices_ != slot.refused) Report(port, refusals_, result);
  slot.refused = indices_;
  Enter(port, indices_, result);
  slot.changed = false;
}

void LatchSet::Report(std::size_t port, const std::vector<sdk::Refusal>& refused,
                      Settlement& result) {
  for (const sdk::Refusal& each : refused) {
    result.refused.push_back({port, slots_[port].batch[each.index], each.reason});
  }
}

void LatchSet::Enter(std::size_t port, const std::vector<std::size_t>& refused,
                     Settlement& result) {
  Slot& slot = slots_[port];
  entering_.clear();
  for (std::size_t i = 0; i < slot.batch.size(); ++i) {
    if (!std::binary_search(refused.begin(), refused.end(), i)) entering_.push_back(slot.batch[i]);
  }
  if (entering_ == slot.content) {
    latches_[port].facts.swap(slot.content);
    return;
  }
  latches_[port].facts.swap(entering_);
  ++latches_[port].version;
  result.changes.push_back({port, slot.stale});
}

/// Versions only grow, so their sum names what a batch of this port is checked against.
std::uint64_t LatchSet::ContextOf(std::size_t port) const {
  std::uint64_t sum = 0;
  for (std::size_t other = 0; other < slots_.size(); ++other) {
    const bool before = slots_[other].from_sensor || (!slots_[port].from_sensor && other < port);
    if (other != port && before) sum += latches_[other].version;
  }
  return sum;
}

}  // namespace latchwork::schedule

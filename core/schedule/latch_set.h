// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_LATCH_SET_H_
#define LATCHWORK_SCHEDULE_LATCH_SET_H_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/schedule/port_contract.h"
#include "latchwork/logic/atom.h"
#include "latchwork/sdk/reasoner.h"
#include "latchwork/sdk/world.h"

namespace latchwork::schedule {

/// What happened to the latches of a layer at the start of a cycle.
struct Settlement {
  struct Change {
    std::size_t port = 0;
    bool stale = false;
  };
  struct Refused {
    std::size_t port = 0;
    logic::Fact fact;
    std::string reason;
  };
  std::vector<Change> changes;
  std::vector<Refused> refused;
  std::vector<std::string> problems;  ///< What the reasoner threw while it checked a batch.

  void Clear();
};

/// The latches of one layer. Batches are offered at any time; they enter the latches when the
/// layer's cycle begins (Settle), checked against its contract and the hard part of its body.
///
/// Who yields to whom: a sensor batch is checked against the other sensor latches alone; a batch of
/// a higher layer against all sensor latches and the input latches before it, and again whenever
/// those change. So what a sensor says is never refused because a higher layer said otherwise
/// (LSA, section 3.3: the lower layer's hard facts are kept).
class LatchSet {
 public:
  struct Input {
    sdk::PortSpec port;
    bool from_sensor = false;
    std::optional<std::uint64_t> stale_after;
  };
  LatchSet(const std::vector<Input>& inputs, logic::SymbolTable& symbols);

  /// A batch that arrives at `tick`. Facts that the port does not declare stay behind.
  void Offer(std::size_t port, const sdk::Batch& batch, std::uint64_t tick);
  /// Brings the latches up to date for a cycle at `tick`; overwrites `result`.
  void Settle(std::uint64_t tick, sdk::Reasoner& reasoner, const sdk::Budget& budget,
              Settlement& result);

  std::span<const sdk::Latch> latches() const { return latches_; }

 private:
  static constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();
  static constexpr std::uint64_t kHidden = kNever - 1;  ///< Version of a latch that shows nothing.

  struct Content {
    std::vector<logic::Fact> facts;
    sdk::Undecided undecided;

    bool empty() const { return facts.empty() && undecided.facts.empty(); }
    /// The undecided facts are numbered after the others.
    const logic::Fact& At(std::size_t index) const;
    void Drop(std::span<const std::size_t> indices);
    void Swap(sdk::Latch& latch);
    friend bool operator==(const Content&, const Content&) = default;
  };

  struct Slot {
    Slot(const Input& input, logic::SymbolTable& symbols)
        : contract(input.port, symbols),
          from_sensor(input.from_sensor),
          stale_after(input.stale_after) {}

    PortContract contract;
    bool from_sensor = false;
    std::optional<std::uint64_t> stale_after;
    Content arriving;
    Content batch;                     ///< The last one that keeps the contract.
    Content content;                   ///< The latch's, while it is hidden from Admit.
    std::vector<std::size_t> refused;  ///< Of `batch`, when it was last checked.
    std::uint64_t version = 0;         ///< Of the latch, also while it is hidden.
    std::uint64_t arrival = 0;
    std::uint64_t context = kNever;  ///< ContextOf at that time.
    bool arrived = false;
    bool changed = false;  ///< `batch` is not the one that was last checked.
    bool stale = false;
    bool due = false;  ///< To be checked in this settlement.
  };

  void TakeBatch(std::size_t port, std::uint64_t tick, Settlement& result);
  bool MarkSensors();
  void Hide(bool inputs);
  void ShowAgain(std::size_t port);
  void RefuseOffences(std::size_t port, Settlement& result);
  void Admit(std::size_t port, sdk::Reasoner& reasoner, const sdk::Budget& budget,
             Settlement& result);
  void Check(std::size_t port, sdk::Reasoner& reasoner, const sdk::Budget& budget);
  void Enter(std::size_t port, const std::vector<std::size_t>& refused, Settlement& result);
  void Report(std::size_t port, const std::vector<sdk::Refusal>& refused, Settlement& result);
  std::uint64_t ContextOf(std::size_t port) const;

  std::vector<Slot> slots_;
  std::vector<sdk::Latch> latches_;
  std::vector<sdk::Refusal> refusals_;
  std::vector<std::size_t> indices_;
  std::vector<logic::Fact> trial_;
  std::vector<sdk::Refusal> found_;
  Content entering_;
};

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_LATCH_SET_H_

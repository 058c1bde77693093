// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_REBUILDER_H_
#define LATCHWORK_PTTP_SATURATION_REBUILDER_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/pttp/saturation/terms.h"

namespace latchwork::pttp::saturation {

/// A term under one of the two variable namespaces that an inference joins.
struct Item {
  TermId term = kNoTerm;
  std::uint32_t bank = 0;
  friend bool operator==(const Item&, const Item&) = default;
};

/// Builds a changed copy of a term bottom-up on a stack of its own.
class Rebuilder {
 public:
  explicit Rebuilder(Terms& terms) : terms_(terms) {}

  /// `enter(item)` gives the finished term, or kNoTerm to go into the arguments of the item, which
  /// it may replace first. `leave(term)` sees each term that was put together and gives it back, or
  /// gives another that is then entered in its place. kNoTerm when the result would be enormous.
  template <class Enter, class Leave>
  TermId Build(Item root, const Enter& enter, const Leave& leave) {
    frames_.clear();
    results_.clear();
    std::size_t steps = 0;
    Push(root, enter);
    while (!frames_.empty()) {
      if (++steps > kMaxSteps) return kNoTerm;
      Frame& frame = frames_.back();
      const auto arguments = terms_.arguments(frame.item.term);
      if (frame.next < arguments.size()) {
        Push({arguments[frame.next++], frame.item.bank}, enter);
        continue;
      }
      const TermId built = Join(frame.item.term, arguments.size());
      frames_.pop_back();
      const TermId next = leave(built);
      if (next == built) {
        results_.push_back(built);
      } else {
        Push({next, 0}, enter);
      }
    }
    return results_.back();
  }

  template <class Enter>
  TermId Build(Item root, const Enter& enter) {
    return Build(root, enter, [](TermId term) { return term; });
  }

 private:
  struct Frame {
    Item item;
    std::uint32_t next = 0;
  };
  static constexpr std::size_t kMaxSteps = 4'000'000;

  template <class Enter>
  void Push(Item item, const Enter& enter) {
    const TermId done = enter(item);
    if (done == kNoTerm) {
      frames_.push_back({item});
    } else {
      results_.push_back(done);
    }
  }

  TermId Join(TermId pattern, std::size_t arity) {
    const std::span<const TermId> arguments(results_.data() + (results_.size() - arity), arity);
    const TermId built = terms_.Make(terms_.head(pattern), arguments);
    results_.resize(results_.size() - arity);
    return built;
  }

  Terms& terms_;
  std::vector<Frame> frames_;
  std::vector<TermId> results_;
};

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_REBUILDER_H_

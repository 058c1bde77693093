// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tableau/tableau.h"

#include <algorithm>
#include <utility>

namespace latchwork::pttp {
namespace {

constexpr std::uint64_t kPollPeriod = 4096;
constexpr std::uint32_t kMostTrailLooked = 256;

}  // namespace

Tableau::Tableau(Matrix& matrix, const Strategy& strategy, std::size_t memory_bytes,
                 std::function<bool()> stop)
    : matrix_(matrix),
      strategy_(strategy),
      memory_bytes_(memory_bytes),
      stop_(std::move(stop)),
      bindings_(matrix) {}

TableauEnd Tableau::Search() {
  for (depth_ = 1; depth_ <= strategy_.deepest; ++depth_) {
    cut_off_ = false;
    for (const std::uint32_t start : matrix_.starts()) {
      const TableauEnd end = Run(start);
      if (end != TableauEnd::kSaturated) return end;
    }
    if (cut_off_) continue;
    const bool incomplete = pruned_ || bindings_.gave_up() || !matrix_.starts_are_complete();
    return incomplete ? TableauEnd::kGaveUp : TableauEnd::kSaturated;
  }
  return TableauEnd::kGaveUp;
}

void Tableau::Begin(std::uint32_t start) {
  bindings_.UndoTo(0, 0);
  bindings_.TrailBelow(0);
  frames_.Truncate(0);
  choices_.Truncate(0);
  lemmata_.Truncate(0);
  steps_.Truncate(0);
  const Entry& entry = matrix_.entry(start);
  const std::uint32_t base = bindings_.Allocate(entry.slots);
  steps_.Push({start, base});
  Frame& root = *frames_.Extend(1);
  root = {};
  root.goal.key = kNone;
  root.next.frame = kNone;
  root.same = kNone;
  root.base = base;
  root.left = depth_;
  place_ = {0, entry.body, kNone};
}

TableauEnd Tableau::Run(std::uint32_t start) {
  Begin(start);
  bool forward = true;
  for (;;) {
    if (inferences_ >= strategy_.inferences) return TableauEnd::kStopped;
    if (++polls_ % kPollPeriod == 0) {
      if (stop_()) return TableauEnd::kStopped;
      if (bytes() > memory_bytes_) return TableauEnd::kMemory;
    }
    if (!forward) {
      if (choices_.empty()) return TableauEnd::kSaturated;
      forward = Retry();
      continue;
    }
    if (!Advance()) return TableauEnd::kClosed;
    forward = Call();
  }
}

/// To the next open goal; false when there is none.
bool Tableau::Advance() {
  while (matrix_.body_literal(place_.literal) == Matrix::kBodyEnd) {
    if (frames_[place_.frame].next.frame == kNone) return false;
    Leave();
  }
  return true;
}

void Tableau::Leave() {
  const Frame& frame = frames_[place_.frame];
  const bool most_general = bindings_.trail_size() - frame.trail <= kMostTrailLooked &&
                            bindings_.BoundOnlyFrom(frame.fresh, frame.trail);
  if (most_general || strategy_.cut == Cut::kInclusive) {
    if (choices_.size() > frame.height) {
      pruned_ = pruned_ || !most_general;
      choices_.Truncate(frame.height);
    }
  } else if (strategy_.cut == Cut::kExclusive && choices_.size() > frame.kept) {
    pruned_ = true;
    choices_.Truncate(frame.kept);
  }
  place_ = frame.next;
  if (strategy_.lemmata) {
    const std::uint64_t older = place_.lemma == kNone ? 0 : lemmata_[place_.lemma].marks;
    lemmata_.Push({frame.goal, place_.lemma, older | MarkOf(frame.goal.key)});
    place_.lemma = static_cast<std::uint32_t>(lemmata_.size() - 1);
  }
}

/// Whether the goal stands on its branch already. `same` becomes the nearest ancestor with its
/// predicate.
inline bool Tableau::IsIrregular(const Goal& goal, std::uint32_t& same) {
  same = kNone;
  if ((frames_[place_.frame].marks & MarkOf(goal.key / 2)) == 0) return false;
  same = place_.frame;
  while (same != kNone && (frames_[same].goal.key ^ goal.key) > 1) same = frames_[same].next.frame;
  for (std::uint32_t i = same; i != kNone; i = frames_[i].same) {
    const Goal& ancestor = frames_[i].goal;
    if (ancestor.key == goal.key && ancestor.print.MayEqual(goal.print) &&
        bindings_.Identical(ancestor.arguments, goal.arguments, goal.arity)) {
      return true;
    }
  }
  return false;
}

inline bool Tableau::IsLemma(const Goal& goal) {
  if (place_.lemma == kNone || (lemmata_[place_.lemma].marks & MarkOf(goal.key)) == 0) {
    return false;
  }
  for (std::uint32_t i = place_.lemma; i != kNone; i = lemmata_[i].next) {
    const Goal& lemma = lemmata_[i].goal;
    if (lemma.key == goal.key && lemma.print.MayEqual(goal.print) &&
        bindings_.Identical(lemma.arguments, goal.arguments, goal.arity)) {
      return true;
    }
  }
  return false;
}

inline std::uint32_t Tableau::NextFitting(const MatrixLiteral& goal, const Fingerprint& print,
                                          std::uint32_t from, bool free_only) const {
  const std::uint32_t end = free_only ? goal.free : goal.size;
  for (; from < end; ++from) {
    if (!print.Clashes(goal.first[from].head)) return from;
  }
  return kNone;
}

bool Tableau::Call() {
  const Frame& frame = frames_[place_.frame];
  const MatrixLiteral& literal = matrix_.goal(matrix_.body_literal(place_.literal));
  Choice& choice = *choices_.Extend(1);
  choices_.Pop();
  Goal& goal = choice.goal;
  goal.key = literal.key;
  goal.arity = literal.arity;
  goal.arguments = bindings_.size();
  goal.print = bindings_.PushArguments(literal, frame.base);
  if (IsIrregular(goal, choice.same)) return false;
  if (strategy_.lemmata && IsLemma(goal)) {
    ++place_.literal;
    return true;
  }
  const bool free_only = frame.left == 0 && cut_off_;
  choice.connection = NextFitting(literal, goal.print, 0, free_only);
  if (choice.connection == kNone && choice.same == kNone) return false;
  choice.ancestor = choice.same;
  choice.place = place_;
  choice.variables = bindings_.size();
  choice.trail = bindings_.trail_size();
  choice.frames = static_cast<std::uint32_t>(frames_.size());
  choice.steps = static_cast<std::uint32_t>(steps_.size());
  choice.lemmata = static_cast<std::uint32_t>(lemmata_.size());
  bindings_.TrailBelow(choice.variables);
  if (choice.ancestor == kNone &&
      NextFitting(literal, goal.print, choice.connection + 1, free_only) == kNone) {
    return TryEntry(choice, literal.first[choice.connection].entry,
                    static_cast<std::uint32_t>(choices_.size()));
  }
  choices_.Extend(1);
  return (choices_.back().ancestor != kNone && TryReductions()) || TryConnections();
}

void Tableau::Rewind(const Choice& choice) { bindings_.UndoTo(choice.trail, choice.variables); }

bool Tableau::Retry() {
  const Choice& choice = choices_.back();
  Rewind(choice);
  frames_.Truncate(choice.frames);
  steps_.Truncate(choice.steps);
  lemmata_.Truncate(choice.lemmata);
  place_ = choice.place;
  bindings_.TrailBelow(choice.variables);
  return (choices_.back().ancestor != kNone && TryReductions()) || TryConnections();
}

inline bool Tableau::TryReductions() {
  Choice& choice = choices_.back();
  const Goal& goal = choice.goal;
  while (choice.ancestor != kNone) {
    const Frame& frame = frames_[choice.ancestor];
    choice.ancestor = frame.same;
    const Goal& ancestor = frame.goal;
    if (ancestor.key == goal.key || ancestor.print.Clashes(goal.print)) continue;
    if (bindings_.UnifyGoals(ancestor.arguments, goal.arguments, goal.arity)) {
      ++inferences_;
      SolvedAtOnce(choice, static_cast<std::uint32_t>(choices_.size() - 1));
      return true;
    }
    Rewind(choice);
  }
  return false;
}

void Tableau::SolvedAtOnce(const Choice& choice, std::uint32_t height) {
  ++place_.literal;
  const bool most_general = bindings_.trail_size() == choice.trail;
  if (choices_.size() == height || (!most_general && strategy_.cut != Cut::kInclusive)) return;
  pruned_ = pruned_ || !most_general;
  choices_.Truncate(height);
}

bool Tableau::TryConnections() {
  const auto height = static_cast<std::uint32_t>(choices_.size() - 1);
  Choice& choice = choices_.back();
  const bool deepest = frames_[place_.frame].left == 0;
  const MatrixLiteral& literal = matrix_.literal(matrix_.body_literal(place_.literal));
  while (choice.connection != kNone) {
    const std::uint32_t entry = literal.first[choice.connection].entry;
    choice.connection =
        NextFitting(literal, choice.goal.print, choice.connection + 1, deepest && cut_off_);
    if (choice.connection == kNone) {
      choices_.Pop();
      return TryEntry(choice, entry, height);
    }
    if (TryEntry(choice, entry, height)) return true;
  }
  choices_.Pop();
  return false;
}

bool Tableau::TryEntry(const Choice& choice, std::uint32_t number, std::uint32_t height) {
  const Entry& entry = matrix_.entry(number);
  const Goal& goal = choice.goal;
  const std::uint32_t base = bindings_.Allocate(entry.slots);
  const bool unified =
      bindings_.UnifyHead(matrix_.head_arguments(entry), base, goal.arguments, goal.arity);
  const bool too_deep = !entry.free && frames_[place_.frame].left == 0;
  if (!unified || too_deep) {
    cut_off_ = cut_off_ || unified;
    Rewind(choice);
    return false;
  }
  ++inferences_;
  steps_.Push({number, base});
  if (entry.unit) {
    SolvedAtOnce(choice, height);
  } else {
    Open(choice, entry, base, height);
  }
  return true;
}

inline void Tableau::Open(const Choice& choice, const Entry& entry, std::uint32_t base,
                          std::uint32_t height) {
  const auto number = static_cast<std::uint32_t>(frames_.size());
  Frame& frame = *frames_.Extend(1);
  const Frame& parent = frames_[place_.frame];
  frame.goal = choice.goal;
  frame.next = {place_.frame, place_.literal + 1, place_.lemma};
  frame.base = base;
  frame.left = parent.left == 0 ? 0 : parent.left - 1;
  frame.same = choice.same;
  frame.height = height;
  frame.kept = static_cast<std::uint32_t>(choices_.size());
  frame.trail = choice.trail;
  frame.fresh = choice.variables;
  frame.marks = parent.marks | MarkOf(choice.goal.key / 2);
  place_ = {number, entry.body, place_.lemma};
}

std::size_t Tableau::bytes() const {
  return matrix_.bytes() + bindings_.bytes() + frames_.bytes() + choices_.bytes() +
         lemmata_.bytes() + steps_.bytes();
}

}  // namespace latchwork::pttp

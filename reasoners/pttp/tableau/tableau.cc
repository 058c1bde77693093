// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tableau/tableau.h"

#include <algorithm>
#include <utility>

namespace latchwork::pttp {
namespace {

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
    for (const Entry* start : matrix_.starts()) {
      const TableauEnd end = Run(*start);
      if (end != TableauEnd::kSaturated) return end;
    }
    if (cut_off_) continue;
    const bool incomplete = pruned_ || bindings_.gave_up() || !matrix_.starts_are_complete();
    return incomplete ? TableauEnd::kGaveUp : TableauEnd::kSaturated;
  }
  return TableauEnd::kGaveUp;
}

void Tableau::Begin(const Entry& start) {
  bindings_.Clear();
  bindings_.TrailBelow(0);
  frames_.Truncate(0);
  choices_.Truncate(0);
  lemmata_.Truncate(0);
  steps_.Truncate(0);
  const std::uint32_t base = bindings_.Allocate(start);
  steps_.Push({&start, base});
  Frame root{};
  root.goal.key = kNone;
  root.next.frame = kNone;
  root.kin = {kNone, kNone};
  root.base = base;
  root.left = depth_;
  frames_.Push(root);
  place_ = {start.body, 0, kNone};
}

TableauEnd Tableau::Run(const Entry& start) {
  Begin(start);
  while (Advance()) {
    if (inferences_ >= strategy_.inferences) return TableauEnd::kStopped;
    if (bindings_.full()) return TableauEnd::kMemory;
    if (++steps_taken_ >= next_poll_) {
      next_poll_ = steps_taken_ + kPollPeriod;
      if (stop_()) return TableauEnd::kStopped;
      if (bytes() > memory_bytes_) return TableauEnd::kMemory;
    }
    bool forward = Call();
    while (!forward) {
      if (choices_.empty()) return TableauEnd::kSaturated;
      ++steps_taken_;
      forward = Retry();
    }
  }
  return TableauEnd::kClosed;
}

/// To the next open goal; false when there is none.
inline bool Tableau::Advance() {
  while (*place_.literal == nullptr) {
    if (frames_[place_.frame].next.frame == kNone) return false;
    Leave();
  }
  return true;
}

void Tableau::Leave() {
  const Frame& frame = frames_[place_.frame];
  const bool most_general = strategy_.prune &&
                            bindings_.trail_size() - frame.trail <= kMostTrailLooked &&
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
    const auto number = static_cast<std::uint32_t>(lemmata_.size());
    Lemma& lemma = *lemmata_.Extend(1);
    lemma.goal = frame.goal;
    if (place_.lemma == kNone) {
      lemma.newest.fill(kNone);
    } else {
      lemma.newest = lemmata_[place_.lemma].newest;
    }
    lemma.next = std::exchange(lemma.newest[KindOf(frame.goal)], number);
    place_.lemma = number;
  }
}

inline bool Tableau::Same(const Goal& earlier, const Goal& goal) {
  return earlier.print.MayEqual(goal.print) &&
         (earlier.hash == goal.hash || earlier.hash == 0 || goal.hash == 0) &&
         bindings_.Identical(earlier.arguments, goal.arguments, goal.literal->arity);
}

inline Tableau::Kin Tableau::KinOf(const Goal& goal) const {
  std::uint32_t nearest = place_.frame;
  if ((frames_[nearest].marks & MarkOf(goal.key / 2)) == 0) return {kNone, kNone};
  while (nearest != kNone && (frames_[nearest].goal.key ^ goal.key) > 1) {
    nearest = frames_[nearest].next.frame;
  }
  if (nearest == kNone) return {kNone, kNone};
  const Frame& frame = frames_[nearest];
  if (frame.goal.key == goal.key) return {nearest, frame.kin.opposite};
  return {frame.kin.opposite, nearest};
}

/// Whether the goal stands on its branch already, `same` being the nearest that may be it.
inline bool Tableau::IsIrregular(const Goal& goal, std::uint32_t same) {
  for (; same != kNone; same = frames_[same].kin.same) {
    if (Same(frames_[same].goal, goal)) return true;
  }
  return false;
}

inline bool Tableau::IsLemma(const Goal& goal) {
  if (place_.lemma == kNone) return false;
  std::uint32_t i = lemmata_[place_.lemma].newest[KindOf(goal)];
  for (; i != kNone; i = lemmata_[i].next) {
    const Goal& lemma = lemmata_[i].goal;
    if (lemma.key == goal.key && Same(lemma, goal)) return true;
  }
  return false;
}

inline const Connection* Tableau::NextFitting(const Goal& goal, const Connection* from,
                                              const Connection* end) {
  for (; from < end; ++from) {
    if (!goal.print.Clashes(from->head)) return from;
  }
  return nullptr;
}

inline const Connection* Tableau::EndOfConnections(const MatrixLiteral& literal) const {
  return cut_off_ && frames_[place_.frame].left == 0 ? literal.free_end : literal.end;
}

bool Tableau::Call() {
  const MatrixLiteral& literal = **place_.literal;
  matrix_.Connect(literal);
  Choice& choice = choices_.Next();
  Goal& goal = choice.goal;
  goal.literal = &literal;
  goal.key = literal.key;
  const auto made = bindings_.PushArguments(literal, frames_[place_.frame].base);
  goal.print = made.print;
  goal.arguments = made.first;
  goal.hash = made.hash;
  choice.kin = KinOf(goal);
  if (IsIrregular(goal, choice.kin.same)) return false;
  if (strategy_.lemmata && IsLemma(goal)) {
    ++place_.literal;
    return true;
  }
  const Connection* end = EndOfConnections(literal);
  choice.connection = NextFitting(goal, literal.first, end);
  if (choice.connection == nullptr && choice.kin.opposite == kNone) return false;
  choice.ancestor = choice.kin.opposite;
  choice.place = place_;
  choice.variables = bindings_.size();
  choice.trail = bindings_.trail_size();
  choice.frames = static_cast<std::uint32_t>(frames_.size());
  choice.steps = static_cast<std::uint32_t>(steps_.size());
  choice.lemmata = static_cast<std::uint32_t>(lemmata_.size());
  bindings_.TrailBelow(choice.variables);
  if (choice.ancestor == kNone) return CallConnections(choice, end);
  choices_.Extend(1);
  return TryReductions() || TryConnections();
}

/// With what is tried last there is no choice.
inline bool Tableau::CallConnections(Choice& choice, const Connection* end) {
  const auto height = static_cast<std::uint32_t>(choices_.size());
  const Entry& entry = *choice.connection->entry;
  choice.connection = NextFitting(choice.goal, choice.connection + 1, end);
  if (choice.connection == nullptr) return TryEntry(choice, entry, height);
  choices_.Extend(1);
  return TryEntry(choice, entry, height) || TryConnections();
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
  return (choice.ancestor != kNone && TryReductions()) || TryConnections();
}

bool Tableau::TryReductions() {
  Choice& choice = choices_.back();
  const Goal& goal = choice.goal;
  while (choice.ancestor != kNone) {
    const Frame& frame = frames_[choice.ancestor];
    choice.ancestor = frame.kin.same;
    const Goal& ancestor = frame.goal;
    if (ancestor.print.Clashes(goal.print)) continue;
    if (bindings_.UnifyGoals(ancestor.arguments, *goal.literal, goal.arguments)) {
      ++inferences_;
      SolvedAtOnce(choice, static_cast<std::uint32_t>(choices_.size() - 1));
      return true;
    }
    Rewind(choice);
  }
  return false;
}

inline void Tableau::SolvedAtOnce(const Choice& choice, std::uint32_t height) {
  ++place_.literal;
  const bool most_general = strategy_.prune && bindings_.trail_size() == choice.trail;
  if (choices_.size() == height || (!most_general && strategy_.cut != Cut::kInclusive)) return;
  pruned_ = pruned_ || !most_general;
  choices_.Truncate(height);
}

inline bool Tableau::TryConnections() {
  const auto height = static_cast<std::uint32_t>(choices_.size() - 1);
  Choice& choice = choices_.back();
  while (choice.connection != nullptr) {
    const Entry& entry = *choice.connection->entry;
    choice.connection =
        NextFitting(choice.goal, choice.connection + 1, EndOfConnections(*choice.goal.literal));
    if (choice.connection == nullptr) {
      choices_.Pop();
      return TryEntry(choice, entry, height);
    }
    if (TryEntry(choice, entry, height)) return true;
  }
  choices_.Pop();
  return false;
}

bool Tableau::TryEntry(const Choice& choice, const Entry& entry, std::uint32_t height) {
  const Goal& goal = choice.goal;
  const std::uint32_t base = bindings_.Allocate(entry);
  const bool unified = bindings_.UnifyHead(entry.head, base, *goal.literal, goal.arguments);
  const bool too_deep = !entry.free && frames_[place_.frame].left == 0;
  if (!unified || too_deep) {
    cut_off_ = cut_off_ || unified;
    Rewind(choice);
    return false;
  }
  ++inferences_;
  steps_.Push({&entry, base});
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
  frame.next = {place_.literal + 1, place_.frame, place_.lemma};
  frame.marks = parent.marks | MarkOf(choice.goal.key / 2);
  frame.base = base;
  frame.left = parent.left == 0 ? 0 : parent.left - 1;
  frame.kin = choice.kin;
  frame.height = height;
  frame.kept = static_cast<std::uint32_t>(choices_.size());
  frame.trail = choice.trail;
  frame.fresh = choice.variables;
  place_ = {entry.body, number, place_.lemma};
}

std::size_t Tableau::bytes() const {
  return matrix_.bytes() + bindings_.bytes() + frames_.bytes() + choices_.bytes() +
         lemmata_.bytes() + steps_.bytes();
}

}  // namespace latchwork::pttp

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
  frames_.Push(
      {{kNone, 0, 0, 0}, {kNone, 0, kNone}, entry.body, entry.size, base, depth_, 0, 0, 0, 0, 0});
  place_ = {0, 0, kNone};
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
  while (place_.index == frames_[place_.frame].size) {
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

std::uint32_t Tableau::LiteralAt(const Place& place) const {
  return matrix_.body_literal(frames_[place.frame].body + place.index);
}

Tableau::Goal Tableau::GoalAt(std::uint32_t literal, std::uint32_t base) const {
  const MatrixLiteral& found = matrix_.literal(literal);
  return {found.key, found.arguments, found.arity, base};
}

inline bool Tableau::SameGoals(const Goal& a, const Goal& b) {
  const Cell* cells = matrix_.cells();
  return bindings_.Identical(cells + a.arguments, a.base, cells + b.arguments, b.base, a.arity);
}

/// Walks the branch: false when the goal stands on it already. `complement` becomes the nearest
/// ancestor that the goal may be reduced with.
bool Tableau::LooksUp(const Goal& goal, std::uint32_t& complement) {
  complement = kNone;
  if ((frames_[place_.frame].marks & MarkOf(goal.key / 2)) == 0) return true;
  for (std::uint32_t i = place_.frame; i != kNone; i = frames_[i].next.frame) {
    const Goal& ancestor = frames_[i].goal;
    if ((ancestor.key ^ goal.key) > 1) continue;
    if (ancestor.key != goal.key) {
      if (complement == kNone) complement = i;
    } else if (SameGoals(goal, ancestor)) {
      return false;
    }
  }
  return true;
}

bool Tableau::IsLemma(const Goal& goal) {
  if (place_.lemma == kNone || (lemmata_[place_.lemma].marks & MarkOf(goal.key)) == 0) {
    return false;
  }
  for (std::uint32_t i = place_.lemma; i != kNone; i = lemmata_[i].next) {
    if (lemmata_[i].goal.key == goal.key && SameGoals(goal, lemmata_[i].goal)) return true;
  }
  return false;
}

Tableau::Keys Tableau::KeysOf(const Goal& goal) const {
  Keys keys{};
  const Cell* arguments = matrix_.cells() + goal.arguments;
  const std::uint32_t count = std::min<std::uint32_t>(goal.arity, Connection::kKeys);
  for (std::uint32_t i = 0; i < count; ++i) keys[i] = bindings_.KeyOf({arguments[i], goal.base});
  return keys;
}

inline bool Tableau::Clash(const Keys& a, const Keys& b) {
  const auto clash = [](std::uint32_t x, std::uint32_t y) { return x != 0 && y != 0 && x != y; };
  return clash(a[0], b[0]) || clash(a[1], b[1]) || clash(a[2], b[2]);
}

inline std::uint32_t Tableau::NextFitting(const ConnectionList& list, const Keys& keys,
                                          std::uint32_t from, bool free_only) const {
  const std::uint32_t end = free_only ? list.free : list.size;
  for (; from < end; ++from) {
    if (!Clash(keys, list.first[from].keys)) return from;
  }
  return kNone;
}

bool Tableau::Call() {
  const std::uint32_t literal = LiteralAt(place_);
  const Frame& frame = frames_[place_.frame];
  const Goal goal = GoalAt(literal, frame.base);
  Choice choice;
  if (!LooksUp(goal, choice.ancestor)) return false;
  if (strategy_.lemmata && IsLemma(goal)) {
    ++inferences_;
    ++place_.index;
    return true;
  }
  const ConnectionList& list = matrix_.Connections(literal);
  const bool free_only = frame.left == 0 && cut_off_;
  choice.keys = KeysOf(goal);
  choice.connection = NextFitting(list, choice.keys, 0, free_only);
  if (choice.connection == kNone && choice.ancestor == kNone) return false;
  choice.place = place_;
  choice.variables = bindings_.size();
  choice.trail = bindings_.trail_size();
  choice.frames = static_cast<std::uint32_t>(frames_.size());
  choice.steps = static_cast<std::uint32_t>(steps_.size());
  choice.lemmata = static_cast<std::uint32_t>(lemmata_.size());
  bindings_.TrailBelow(choice.variables);
  if (choice.ancestor == kNone &&
      NextFitting(list, choice.keys, choice.connection + 1, free_only) == kNone) {
    return TryEntry(goal, matrix_.entry(list.first[choice.connection].entry), choice,
                    static_cast<std::uint32_t>(choices_.size()));
  }
  choices_.Push(choice);
  return TryReductions(goal) || TryConnections(goal, list);
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
  const std::uint32_t literal = LiteralAt(place_);
  const Goal goal = GoalAt(literal, frames_[place_.frame].base);
  return TryReductions(goal) || TryConnections(goal, matrix_.Connections(literal));
}

bool Tableau::TryReductions(const Goal& goal) {
  Choice& choice = choices_.back();
  const Cell* cells = matrix_.cells();
  while (choice.ancestor != kNone) {
    const Frame& frame = frames_[choice.ancestor];
    choice.ancestor = frame.next.frame;
    const Goal& ancestor = frame.goal;
    if (ancestor.key != (goal.key ^ 1U) || Clash(choice.keys, KeysOf(ancestor))) continue;
    if (bindings_.Unify(cells + ancestor.arguments, ancestor.base, cells + goal.arguments,
                        goal.base, goal.arity, false)) {
      ++inferences_;
      SolvedAtOnce(choice, static_cast<std::uint32_t>(choices_.size() - 1));
      return true;
    }
    Rewind(choice);
  }
  return false;
}

void Tableau::SolvedAtOnce(const Choice& choice, std::uint32_t height) {
  ++place_.index;
  const bool most_general = bindings_.trail_size() == choice.trail;
  if (choices_.size() == height || (!most_general && strategy_.cut != Cut::kInclusive)) return;
  pruned_ = pruned_ || !most_general;
  choices_.Truncate(height);
}

bool Tableau::TryConnections(const Goal& goal, const ConnectionList& list) {
  const auto height = static_cast<std::uint32_t>(choices_.size() - 1);
  const bool deepest = frames_[place_.frame].left == 0;
  while (choices_.back().connection != kNone) {
    Choice& choice = choices_.back();
    const std::uint32_t current = choice.connection;
    choice.connection = NextFitting(list, choice.keys, current + 1, deepest && cut_off_);
    if (choice.connection == kNone) {
      Choice last = choice;
      choices_.Pop();
      return TryEntry(goal, matrix_.entry(list.first[current].entry), last, height);
    }
    if (TryEntry(goal, matrix_.entry(list.first[current].entry), choice, height)) return true;
  }
  choices_.Pop();
  return false;
}

bool Tableau::TryEntry(const Goal& goal, const Entry& entry, Choice& choice, std::uint32_t height) {
  const std::uint32_t arguments = matrix_.literal(entry.head).arguments;
  const Cell* cells = matrix_.cells();
  const std::uint32_t base = bindings_.Allocate(entry.slots);
  const bool unified = bindings_.Unify(cells + arguments, base, cells + goal.arguments, goal.base,
                                       goal.arity, entry.linear);
  const bool too_deep = entry.size > 0 && !entry.ground && frames_[place_.frame].left == 0;
  if (!unified || too_deep) {
    cut_off_ = cut_off_ || (unified && too_deep);
    Rewind(choice);
    return false;
  }
  ++inferences_;
  steps_.Push({matrix_.number(entry), base});
  if (entry.size == 0) {
    SolvedAtOnce(choice, height);
  } else {
    Open(goal, entry, base, choice, height);
  }
  return true;
}

void Tableau::Open(const Goal& goal, const Entry& entry, std::uint32_t base, const Choice& choice,
                   std::uint32_t height) {
  const std::uint32_t left = frames_[place_.frame].left;
  frames_.Push({goal,
                {place_.frame, place_.index + 1, place_.lemma},
                entry.body,
                entry.size,
                base,
                left == 0 ? 0 : left - 1,
                height,
                static_cast<std::uint32_t>(choices_.size()),
                choice.trail,
                choice.variables,
                frames_[place_.frame].marks | MarkOf(goal.key / 2)});
  place_ = {static_cast<std::uint32_t>(frames_.size() - 1), 0, place_.lemma};
}

std::size_t Tableau::bytes() const {
  return matrix_.bytes() + bindings_.bytes() + frames_.bytes() + choices_.bytes() +
         lemmata_.bytes() + steps_.bytes();
}

logic::Term Tableau::Export(Instance term, std::vector<std::uint32_t>& variables) const {
  struct Pending {
    Instance term;
    std::vector<logic::Term> arguments;
  };
  std::vector<Pending> stack;
  const auto leaf = [&](Instance atom) {
    if (TagOfCell(atom.cell) == kConstantTag) return matrix_.functor(OffsetOfCell(atom.cell));
    const std::uint32_t variable = atom.base + SlotOfCell(atom.cell);
    auto place = std::find(variables.begin(), variables.end(), variable);
    if (place == variables.end()) place = variables.insert(place, variable);
    return logic::Term::Var(static_cast<logic::Variable>(place - variables.begin()));
  };
  term = bindings_.Resolve(term);
  if (TagOfCell(term.cell) < kOpenTag) return leaf(term);
  stack.push_back({term, {}});
  for (;;) {
    Pending& top = stack.back();
    const Cell* block = matrix_.cells() + OffsetOfCell(top.term.cell);
    if (top.arguments.size() < block[1]) {
      const Instance next = bindings_.Resolve({block[2 + top.arguments.size()], top.term.base});
      if (TagOfCell(next.cell) < kOpenTag) {
        top.arguments.push_back(leaf(next));
      } else {
        stack.push_back({next, {}});
      }
      continue;
    }
    logic::Term made =
        logic::Term::Compound(matrix_.functor(block[0]).symbol(), std::move(top.arguments));
    stack.pop_back();
    if (stack.empty()) return made;
    stack.back().arguments.push_back(std::move(made));
  }
}

ClauseInstance Tableau::InstanceOf(const Step& step, std::vector<std::uint32_t>& variables) const {
  const Entry& entry = matrix_.entry(step.entry);
  ClauseInstance instance{entry.clause, {}, {}};
  for (const std::uint32_t index : matrix_.ClauseLiterals(entry.clause)) {
    const MatrixLiteral& literal = matrix_.literal(index);
    std::vector<logic::Term> arguments;
    for (std::uint32_t i = 0; i < literal.arity; ++i) {
      arguments.push_back(Export({matrix_.cells()[literal.arguments + i], step.base}, variables));
    }
    instance.literals.push_back(
        {(literal.key & 1U) != 0, logic::Atom(matrix_.predicate(literal.key), arguments)});
  }
  for (std::uint32_t slot = 0; slot < entry.slots; ++slot) {
    instance.values.push_back(Export({CellOfSlot(slot), step.base}, variables));
  }
  return instance;
}

std::vector<ClauseInstance> Tableau::Refutation() const {
  std::vector<ClauseInstance> result;
  std::vector<std::uint32_t> variables;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    result.push_back(InstanceOf(steps_[i], variables));
  }
  return result;
}

}  // namespace latchwork::pttp

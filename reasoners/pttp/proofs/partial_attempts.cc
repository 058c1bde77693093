// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/partial_attempts.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "latchwork/logic/arithmetic.h"
#include "reasoners/pttp/proofs/computed_conclusions.h"
#include "reasoners/pttp/proofs/instances.h"

namespace latchwork::pttp {
namespace {

using logic::Clause;
using logic::Literal;
using logic::Term;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t kDeepest = 100;
constexpr std::uint32_t kLongest = 1000;
constexpr std::size_t kMostDeadEnds = 1000;
constexpr std::size_t kMostAbove = 8;

bool IsComputed(const Literal& literal) {
  const std::string_view name = literal.atom.predicate().name();
  return name == "=" || name.starts_with('$');
}

class Attempts {
 public:
  Attempts(const ClauseIndex& index, logic::SymbolTable& symbols, std::uint64_t most_work)
      : index_(index), arithmetic_(symbols), most_work_(most_work) {}

  PartialAttempts Make(std::span<const std::uint32_t> starts) {
    work_end_ = most_work_ / 2;
    Deepen([&] {
      for (const std::uint32_t start : starts) Begin(start, std::nullopt);
    });
    if (!result_.found_proof) {
      TryEachGoal(starts);
      result_.found_proof = false;
    }
    Sort();
    return std::move(result_);
  }

 private:
  /// An open goal: the complement of a literal of a clause copy.
  struct Goal {
    const Literal* literal;
    std::uint32_t base;
    std::uint32_t parent;
    std::uint32_t next;
    std::uint32_t depth;
  };

  static std::pair<std::uint32_t, std::uint32_t> RankOf(const DeadEnd& dead_end) {
    return {dead_end.open, kLongest - std::min(dead_end.solved, kLongest)};
  }

  template <typename Level>
  void Deepen(const Level& level) {
    too_deep_ = true;
    for (deepest_ = 1; deepest_ <= kDeepest && too_deep_ && !IsOver(); ++deepest_) {
      too_deep_ = false;
      level();
    }
    result_.cut_off = result_.cut_off || too_deep_ || IsOutOfWork();
  }

  /// Each goal of a start clause for itself: what else is wrong with a conjunction.
  void TryEachGoal(std::span<const std::uint32_t> starts) {
    for (const std::uint32_t start : starts) {
      const auto size = static_cast<std::uint32_t>(Find(start).literals.size());
      for (std::uint32_t i = 0; size > 1 && i < size; ++i) {
        const std::uint64_t done = instances_.work();
        work_end_ = done + (most_work_ - std::min(done, most_work_)) / (size - i);
        result_.found_proof = false;
        Deepen([&] { Begin(start, i); });
      }
    }
  }

  /// All goals of a start clause, or only one of them.
  void Begin(std::uint32_t start, std::optional<std::uint32_t> only) {
    if (IsOver()) return;
    const Clause& clause = Find(start);
    const Instances::Mark mark = instances_.mark();
    const std::uint32_t base = instances_.Copy(clause.variable_names.size());
    std::uint32_t first = kNone;
    left_out_ = 0;
    if (only) {
      goals_.push_back({&clause.literals[*only], base, kNone, kNone, 0});
      first = 0;
      left_out_ = static_cast<std::uint32_t>(clause.literals.size() - 1);
    } else {
      first = Open({start, kNone}, base, kNone, kNone);
    }
    Solve(first, 0);
    goals_.clear();
    instances_.UndoTo(mark);
  }

  void Sort() {
    std::vector<DeadEnd>& sorted = result_.dead_ends;
    for (auto& [text, dead_end] : dead_ends_) sorted.push_back(std::move(dead_end));
    std::ranges::stable_sort(sorted, {}, RankOf);
  }

  const Clause& Find(std::uint32_t clause) const { return index_.clauses()[clause]; }
  bool IsOutOfWork() const { return instances_.work() >= work_end_; }
  bool IsOver() const { return IsOutOfWork() || result_.found_proof; }

  /// The goals that entering a clause by one of its literals leaves, before `next`. What can be
  /// computed comes last, when its arguments are best known.
  std::uint32_t Open(const LiteralPlace& entry, std::uint32_t base, std::uint32_t parent,
                     std::uint32_t next) {
    const auto& literals = Find(entry.clause).literals;
    const std::uint32_t depth = parent == kNone ? 0 : goals_[parent].depth + 1;
    for (const bool computed : {true, false}) {
      for (auto i = static_cast<std::uint32_t>(literals.size()); i > 0; --i) {
        if (i - 1 == entry.literal || IsComputed(literals[i - 1]) != computed) continue;
        goals_.push_back({&literals[i - 1], base, parent, next, depth});
        next = static_cast<std::uint32_t>(goals_.size() - 1);
      }
    }
    return next;
  }

  void Solve(std::uint32_t place, std::uint32_t solved) {
    if (place == kNone) {
      result_.found_proof = true;
      return;
    }
    if (solved >= kLongest) {
      too_deep_ = true;
      return;
    }
    const std::size_t literals = literals_.size();
    const Goal goal = Computed(goals_[place]);
    if (!IsRepeated(goal)) Match(place, goal, solved);
    literals_.resize(literals);
  }

  void Match(std::uint32_t place, const Goal& goal, std::uint32_t solved) {
    bool matched = false;
    if (IsComputed(*goal.literal)) matched = Compute(goal, solved);
    matched = Reduce(goal, solved) || matched;
    matched = Extend(place, goal, solved) || matched;
    if (!matched && !IsOver()) Note(goal, solved);
  }

  /// The goal with what its arguments come to, if it has no variables left.
  Goal Computed(Goal goal) {
    const logic::Atom& atom = goal.literal->atom;
    if (IsComputed(*goal.literal) ||
        std::ranges::none_of(atom.arguments(), [](const Term& t) { return pttp::IsComputed(t); })) {
      return goal;
    }
    Instances::Numbers free;
    const auto exported = instances_.Export(atom, goal.base, free);
    if (!exported || !free.empty()) return goal;
    std::vector<Term> arguments;
    for (const Term& argument : exported->arguments()) {
      arguments.push_back(arithmetic_.Normalize(argument).value_or(argument));
    }
    literals_.push_back(
        {goal.literal->positive, logic::Atom(exported->predicate(), std::move(arguments))});
    goal.literal = &literals_.back();
    return goal;
  }

  bool IsRepeated(const Goal& goal) const {
    for (std::uint32_t i = goal.parent; i != kNone; i = goals_[i].parent) {
      const Goal& above = goals_[i];
      if (above.literal->positive == goal.literal->positive &&
          instances_.Identical(above.literal->atom, above.base, goal.literal->atom, goal.base)) {
        return true;
      }
    }
    return false;
  }

  bool Reduce(const Goal& goal, std::uint32_t solved) {
    bool matched = false;
    for (std::uint32_t i = goal.parent; i != kNone && !IsOver(); i = goals_[i].parent) {
      const Goal above = goals_[i];
      if (above.literal->positive == goal.literal->positive) continue;
      if (KeyOf(*above.literal).name != KeyOf(*goal.literal).name) continue;
      const Instances::Mark mark = instances_.mark();
      if (instances_.Unify(above.literal->atom, above.base, goal.literal->atom, goal.base)) {
        matched = true;
        Solve(goal.next, solved + 1);
      }
      instances_.UndoTo(mark);
    }
    return matched;
  }

  bool Extend(std::uint32_t place, const Goal& goal, std::uint32_t solved) {
    bool matched = false;
    for (const LiteralPlace& entry : index_.Find(KeyOf(ComplementOf(*goal.literal)))) {
      if (IsOver()) return true;
      const Clause& clause = Find(entry.clause);
      const Instances::Mark mark = instances_.mark();
      const std::size_t goals = goals_.size();
      const std::uint32_t base = instances_.Copy(clause.variable_names.size());
      if (instances_.Unify(index_.literal(entry).atom, base, goal.literal->atom, goal.base)) {
        matched = true;
        if (clause.literals.size() > 1 && goal.depth + 1 > deepest_) {
          too_deep_ = true;
        } else {
          Solve(Open(entry, base, place, goal.next), solved + 1);
        }
      }
      goals_.resize(goals);
      instances_.UndoTo(mark);
    }
    return matched;
  }

  /// Whether arithmetic or identity makes the goal true.
  bool Compute(const Goal& goal, std::uint32_t solved) {
    const Instances::Mark mark = instances_.mark();
    const std::size_t values = values_.size();
    const bool holds = IsTrue(goal);
    if (holds) Solve(goal.next, solved + 1);
    instances_.UndoTo(mark);
    values_.resize(values);
    return holds;
  }

  bool IsTrue(const Goal& goal) {
    const logic::Atom& atom = goal.literal->atom;
    const bool wanted = !goal.literal->positive;
    std::vector<TermCopy> arguments;
    for (const Term& argument : atom.arguments()) {
      arguments.push_back(Value({&argument, goal.base}));
    }
    if (const auto known = arithmetic_.FindPredicate(atom.predicate(), atom.arity())) {
      std::vector<Term> numbers;
      for (const TermCopy& argument : arguments) {
        Instances::Numbers free;
        numbers.push_back(instances_.Export(argument, free).value_or(Term()));
      }
      return logic::Arithmetic::Evaluate(*known, numbers) == wanted;
    }
    if (atom.predicate().name() != "=" || arguments.size() != 2) return false;
    if (wanted) return instances_.Unify(arguments[0], arguments[1]);
    return AreDistinct(arguments[0], arguments[1]);
  }

  /// The term, computed if it can be.
  TermCopy Value(TermCopy term) {
    Instances::Numbers free;
    const auto exported = instances_.Export(term, free);
    if (!exported || !exported->is_ground()) return term;
    auto number = arithmetic_.Normalize(*exported);
    if (!number) return term;
    values_.push_back(std::move(*number));
    return {&values_.back(), 0};
  }

  /// Numbers and distinct objects are unequal unless they are the same.
  bool AreDistinct(TermCopy a, TermCopy b) const {
    Instances::Numbers free;
    const auto left = instances_.Export(a, free);
    const auto right = instances_.Export(b, free);
    const auto is_fixed = [](const std::optional<Term>& term) {
      return term &&
             (term->is_number() || (term->kind() == Term::Kind::kConstant &&
                                    term->symbol().kind() == logic::SymbolKind::kDistinctObject));
    };
    return is_fixed(left) && is_fixed(right) && *left != *right;
  }

  void Note(const Goal& goal, std::uint32_t solved) {
    Instances::Numbers numbers;
    auto atom = instances_.Export(goal.literal->atom, goal.base, numbers);
    if (!atom) return;
    DeadEnd dead_end{{!goal.literal->positive, std::move(*atom)}, {}, solved, left_out_};
    for (std::uint32_t i = goal.next; i != kNone; i = goals_[i].next) ++dead_end.open;
    std::string text = ToString(dead_end.goal);
    const auto known = dead_ends_.find(text);
    if (known == dead_ends_.end() ? dead_ends_.size() >= kMostDeadEnds
                                  : RankOf(known->second) <= RankOf(dead_end)) {
      return;
    }
    for (std::uint32_t i = goal.parent; i != kNone && dead_end.above.size() < kMostAbove;
         i = goals_[i].parent) {
      auto above = instances_.Export(goals_[i].literal->atom, goals_[i].base, numbers);
      if (!above) break;
      dead_end.above.push_back({!goals_[i].literal->positive, std::move(*above)});
    }
    dead_ends_.insert_or_assign(std::move(text), std::move(dead_end));
  }

  const ClauseIndex& index_;
  logic::Arithmetic arithmetic_;
  std::uint64_t most_work_;
  std::uint64_t work_end_ = 0;
  Instances instances_;
  std::vector<Goal> goals_;
  std::deque<Term> values_;       ///< Of terms that were computed.
  std::deque<Literal> literals_;  ///< Of goals whose arguments were computed.
  std::map<std::string, DeadEnd> dead_ends_;
  PartialAttempts result_;
  std::uint32_t deepest_ = 0;
  std::uint32_t left_out_ = 0;  ///< Goals of the start clause that are not tried.
  bool too_deep_ = false;
};

}  // namespace

PartialAttempts TryToProve(const ClauseIndex& index, std::span<const std::uint32_t> starts,
                           logic::SymbolTable& symbols, std::uint64_t most_work) {
  return Attempts(index, symbols, most_work).Make(starts);
}

}  // namespace latchwork::pttp

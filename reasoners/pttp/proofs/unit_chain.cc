// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/unit_chain.h"

#include <algorithm>
#include <utility>

#include "reasoners/pttp/proofs/propagation.h"

namespace latchwork::pttp {
namespace {

using Literal = PropositionalLiteral;
using Clause = PropositionalClause;

constexpr std::size_t kNone = Propagation::kNone;

/// Searches for a model and, for each conflict, learns a clause; the steps that lead there are
/// kept. Clauses are numbered: premises first, then steps.
class Learner {
 public:
  Learner(const std::vector<Clause>& premises, const ChainLimits& limits)
      : limits_(limits), premises_(premises.size()) {
    for (Clause premise : premises) {
      std::sort(premise.begin(), premise.end());
      premise.erase(std::unique(premise.begin(), premise.end()), premise.end());
      search_.Add(std::move(premise));
    }
    units_.assign(search_.atoms(), kNone);
    is_seen_.resize(search_.atoms());
  }

  /// Whether a contradiction was found.
  bool Run() {
    for (std::size_t i = 0; i < premises_; ++i) {
      const std::size_t conflict = search_.Watch(i);
      if (conflict != kNone) return Finish(conflict);
    }
    for (std::size_t conflicts = 0;; ++conflicts) {
      std::size_t conflict = search_.Propagate();
      while (conflict == kNone && search_.Decide()) conflict = search_.Propagate();
      if (conflict == kNone) return false;
      if (search_.level() == 0) return Finish(conflict);
      if (conflicts >= limits_.conflicts) return false;
      Learn(conflict);
    }
  }

  /// Without the steps that the last one does not need.
  std::vector<ChainStep> Take() {
    std::vector<bool> needed(steps_.size());
    needed.back() = true;
    for (std::size_t i = steps_.size(); i-- > 0;) {
      if (!needed[i]) continue;
      for (const std::size_t parent : steps_[i].parents) {
        if (parent >= premises_) needed[parent - premises_] = true;
      }
    }
    std::vector<std::size_t> place(steps_.size());
    std::vector<ChainStep> chain;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      if (!needed[i]) continue;
      place[i] = premises_ + chain.size();
      for (std::size_t& parent : steps_[i].parents) {
        if (parent >= premises_) parent = place[parent - premises_];
      }
      chain.push_back(std::move(steps_[i]));
    }
    return chain;
  }

 private:
  std::size_t AddStep(Clause clause, std::vector<std::size_t> parents) {
    steps_.push_back({clause, std::move(parents)});
    return search_.Add(std::move(clause));
  }

  /// A step for a literal of level 0; those that it rests on come before.
  std::size_t UnitOf(std::size_t atom) {
    std::vector<std::size_t> open{atom};
    while (!open.empty()) {
      const std::size_t reason = search_.ReasonOf(open.back());
      std::vector<std::size_t> parents;
      Literal unit = 0;
      const std::size_t before = open.size();
      for (const Literal each : search_.clause(reason)) {
        if (search_.IsTrue(each)) {
          unit = each;
          continue;
        }
        parents.push_back(units_[AtomOf(each)]);
        if (parents.back() == kNone) open.push_back(AtomOf(each));
      }
      if (open.size() > before) continue;
      open.pop_back();
      if (units_[AtomOf(unit)] != kNone) continue;
      parents.push_back(reason);
      units_[AtomOf(unit)] = parents.size() == 1 ? reason : AddStep({unit}, std::move(parents));
    }
    return units_[atom];
  }

  /// The literals of a clause enter the resolvent, those of level 0 as parents.
  void Resolve(std::size_t index) {
    parents_.push_back(index);
    for (const Literal each : search_.clause(index)) {
      const std::size_t atom = AtomOf(each);
      if (is_seen_[atom] || search_.IsTrue(each)) continue;
      if (search_.LevelOf(atom) == 0) {
        AddParent(UnitOf(atom));
        continue;
      }
      is_seen_[atom] = true;
      touched_.push_back(atom);
      if (search_.LevelOf(atom) == search_.level()) {
        ++open_;
      } else {
        lower_.push_back(each);
      }
    }
  }

  /// As many as Resolve adds at most.
  std::size_t ParentsOf(std::size_t index) const {
    const Clause& clause = search_.clause(index);
    const auto units = std::count_if(clause.begin(), clause.end(), [&](Literal each) {
      return search_.IsFalse(each) && search_.LevelOf(AtomOf(each)) == 0;
    });
    return 1 + static_cast<std::size_t>(units);
  }

  void AddParent(std::size_t parent) {
    if (std::find(parents_.begin(), parents_.end(), parent) == parents_.end()) {
      parents_.push_back(parent);
    }
  }

  /// What stands when all literals seen at this level up to the trail's `end` are left.
  Clause Resolvent(std::size_t end) const {
    Clause clause;
    for (std::size_t i = end; i-- > search_.level_begin();) {
      const Literal literal = search_.trail()[i];
      if (is_seen_[AtomOf(literal)]) clause.push_back(Negated(literal));
    }
    clause.insert(clause.end(), lower_.begin(), lower_.end());
    return clause;
  }

  /// Resolves a conflict up to its first unique implication point, and jumps back.
  void Learn(std::size_t conflict) {
    parents_.clear();
    lower_.clear();
    open_ = 0;
    Resolve(conflict);
    std::size_t end = search_.trail().size();
    for (;; --end) {
      const std::size_t atom = AtomOf(search_.trail()[end - 1]);
      if (!is_seen_[atom]) continue;
      if (open_ == 1) break;
      const std::size_t reason = search_.ReasonOf(atom);
      if (parents_.size() + ParentsOf(reason) > limits_.parents) {
        parents_ = {AddStep(Resolvent(end), std::move(parents_))};
      }
      --open_;
      Resolve(reason);
    }
    Assert(Resolvent(end));
    for (const std::size_t each : touched_) is_seen_[each] = false;
    touched_.clear();
  }

  /// Learns a clause of which the first literal is the only one of its level.
  void Assert(Clause clause) {
    std::size_t level = 0;
    for (std::size_t i = 1; i < clause.size(); ++i) {
      const std::size_t of_literal = search_.LevelOf(AtomOf(clause[i]));
      if (of_literal <= level) continue;
      level = of_literal;
      std::swap(clause[1], clause[i]);
    }
    search_.UndoTo(level);
    search_.Watch(AddStep(std::move(clause), std::move(parents_)));
  }

  bool Finish(std::size_t conflict) {
    std::vector<std::size_t> parents;
    for (const Literal each : search_.clause(conflict)) parents.push_back(UnitOf(AtomOf(each)));
    parents.push_back(conflict);
    AddStep({}, std::move(parents));
    return true;
  }

  const ChainLimits limits_;
  const std::size_t premises_;
  Propagation search_;
  std::vector<ChainStep> steps_;
  std::vector<std::size_t> units_;  ///< By atom: the clause that proves it, where it has level 0.

  // Of the conflict that is being resolved.
  std::vector<std::size_t> parents_;
  std::vector<bool> is_seen_;  ///< By atom.
  std::vector<std::size_t> touched_;
  std::vector<Literal> lower_;  ///< Of lower levels.
  std::size_t open_ = 0;        ///< Of this level, seen and not yet resolved.
};

}  // namespace

std::optional<std::vector<ChainStep>> UnitChain(const std::vector<PropositionalClause>& premises,
                                                const ChainLimits& limits) {
  Learner learner(premises, limits);
  if (!learner.Run()) return std::nullopt;
  return learner.Take();
}

}  // namespace latchwork::pttp

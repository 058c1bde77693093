// SPDX-License-Identifier: BSD-3-Clause
#include "apps/check_proof/clause_match.h"

#include <algorithm>
#include <map>

namespace latchwork::check_proof {
namespace {

using logic::Literal;
using logic::Term;
using logic::Variable;
using Kind = Tree::Kind;

constexpr std::size_t kMostSteps = 2'000'000;
constexpr std::size_t kMostOpen = 10'000;

/// Formulas still to be covered, as a list that alternatives share.
struct Task {
  const Tree* tree;
  const Task* next;
};

class Matcher {
 public:
  explicit Matcher(const std::vector<Literal>& clause) : clause_(clause) {}

  bool Cover(const Task* task) {
    if (task == nullptr) return true;
    if (open_ == kMostOpen) steps_ = kMostSteps;
    if (++steps_ > kMostSteps) return false;
    ++open_;
    const bool covered = CoverOne(task);
    --open_;
    return covered;
  }

  bool gave_up() const { return steps_ > kMostSteps; }

 private:
  bool CoverOne(const Task* task) {
    const Tree& tree = *task->tree;
    switch (tree.kind) {
      case Kind::kTrue:
      case Kind::kExists:
        return false;
      case Kind::kFalse:
        return Cover(task->next);
      case Kind::kLiteral:
        return CoverLiteral(tree.literal, task->next);
      case Kind::kAnd:
        for (const Tree& child : tree.children) {
          const Task one{&child, task->next};
          if (Cover(&one)) return true;
        }
        return false;
      case Kind::kForall:
      case Kind::kOr:
        break;
    }
    std::vector<Task> tasks(tree.children.size());
    const Task* first = task->next;
    for (std::size_t i = tasks.size(); i-- > 0;) {
      tasks[i] = {&tree.children[i], first};
      first = &tasks[i];
    }
    return Cover(first);
  }

  bool CoverLiteral(const Literal& literal, const Task* rest) {
    return std::any_of(clause_.begin(), clause_.end(), [&](const Literal& target) {
      if (literal.positive != target.positive || NameOf(literal.atom) != NameOf(target.atom)) {
        return false;
      }
      const std::size_t mark = bound_.size();
      if (Match(literal, target) && Cover(rest)) return true;
      Undo(mark);
      return false;
    });
  }

  bool Match(const Literal& literal, const Literal& target) {
    for (std::size_t i = 0; i < literal.atom.arity(); ++i) {
      if (!Match(literal.atom.argument(i), target.atom.argument(i))) return false;
    }
    return true;
  }

  bool Match(const Term& pattern, const Term& target) {
    ++steps_;
    if (pattern.is_variable()) {
      const auto [place, is_new] = values_.emplace(pattern.variable(), target);
      if (is_new) bound_.push_back(pattern.variable());
      return place->second == target;
    }
    if (pattern.is_ground() || target.is_variable()) return pattern == target;
    const auto arguments = pattern.arguments();
    const auto others = target.arguments();
    if (arguments.size() != others.size() || pattern.symbol() != target.symbol()) return false;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (!Match(arguments[i], others[i])) return false;
    }
    return true;
  }

  void Undo(std::size_t mark) {
    for (; bound_.size() > mark; bound_.pop_back()) values_.erase(bound_.back());
  }

  const std::vector<Literal>& clause_;
  std::map<Variable, Term> values_;
  std::vector<Variable> bound_;
  std::size_t steps_ = 0;
  std::size_t open_ = 0;
};

}  // namespace

Verdict MatchesClause(const Tree& formula, const std::vector<Literal>& clause) {
  Matcher matcher(clause);
  const Task task{&formula, nullptr};
  if (matcher.Cover(&task)) return Verdict::kYes;
  return matcher.gave_up() ? Verdict::kTooHard : Verdict::kNo;
}

}  // namespace latchwork::check_proof

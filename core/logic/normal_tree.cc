// SPDX-License-Identifier: BSD-3-Clause
#include "core/logic/normal_tree.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace latchwork::logic {

namespace {

using Kind = NormalTree::Kind;
using Id = NormalTree::Id;
using Node = NormalTree::Node;

Kind Dual(Kind kind) {
  switch (kind) {
    case Kind::kTrue:
      return Kind::kFalse;
    case Kind::kFalse:
      return Kind::kTrue;
    case Kind::kAnd:
      return Kind::kOr;
    case Kind::kOr:
      return Kind::kAnd;
    case Kind::kForall:
      return Kind::kExists;
    case Kind::kExists:
      return Kind::kForall;
    default:
      return kind;
  }
}

Kind PositiveKind(Formula::Kind kind) {
  switch (kind) {
    case Formula::Kind::kTrue:
      return Kind::kTrue;
    case Formula::Kind::kFalse:
      return Kind::kFalse;
    case Formula::Kind::kAnd:
      return Kind::kAnd;
    case Formula::Kind::kOr:
    case Formula::Kind::kImplies:
      return Kind::kOr;
    case Formula::Kind::kEquivalent:
      return Kind::kEquivalent;
    case Formula::Kind::kForall:
      return Kind::kForall;
    case Formula::Kind::kExists:
      return Kind::kExists;
    default:
      return Kind::kLiteral;
  }
}

/// Turns a formula into nodes, children first.
class Builder {
 public:
  explicit Builder(NormalTree& tree) : tree_(tree) {}

  Id Build(const Formula& formula, bool positive) {
    Begin(formula, positive, Kind::kLiteral);
    while (!open_.empty()) {
      Frame& frame = open_.back();
      const auto children = frame.formula->children();
      if (frame.next == children.size()) {
        End();
        continue;
      }
      const std::size_t index = frame.next++;
      Begin(children[index], ChildSign(frame, index), frame.kind);
    }
    return values_.back();
  }

 private:
  struct Frame {
    const Formula* formula;
    bool positive;
    Kind kind;       ///< Of the node that the children belong to.
    bool is_merged;  ///< They belong to a node further out.
    std::size_t first_value;
    std::size_t next = 0;
  };

  static bool ChildSign(const Frame& frame, std::size_t index) {
    switch (frame.formula->kind()) {
      case Formula::Kind::kNot:
        return !frame.positive;
      case Formula::Kind::kImplies:
        return index == 0 ? !frame.positive : frame.positive;
      case Formula::Kind::kEquivalent:
        return index == 0 || frame.positive;
      default:
        return frame.positive;
    }
  }

  void Begin(const Formula& formula, bool positive, Kind outer) {
    if (formula.kind() == Formula::Kind::kNot) {
      open_.push_back({&formula, positive, outer, true, values_.size()});
      return;
    }
    const Kind kind = positive ? PositiveKind(formula.kind()) : Dual(PositiveKind(formula.kind()));
    if (kind == Kind::kTrue || kind == Kind::kFalse) {
      values_.push_back(tree_.Add({.kind = kind}));
    } else if (kind == Kind::kLiteral) {
      values_.push_back(tree_.Add({.kind = kind, .positive = positive, .atom = &formula.atom()}));
    } else {
      const bool is_merged = kind == outer && (kind == Kind::kAnd || kind == Kind::kOr);
      open_.push_back({&formula, positive, kind, is_merged, values_.size()});
    }
  }

  void End() {
    const Frame frame = open_.back();
    open_.pop_back();
    if (frame.is_merged) return;
    const auto first = values_.begin() + static_cast<std::ptrdiff_t>(frame.first_value);
    std::vector<Id> children(first, values_.end());
    values_.erase(first, values_.end());
    values_.push_back(Join(frame, std::move(children)));
  }

  Id Join(const Frame& frame, std::vector<Id> children) {
    const Kind first_kind = tree_.nodes[children[0]].kind;
    if (frame.kind == Kind::kForall || frame.kind == Kind::kExists) {
      if (first_kind == Kind::kTrue || first_kind == Kind::kFalse) return children[0];
      const auto variables = frame.formula->variables();
      return tree_.Add({.kind = frame.kind,
                        .children = std::move(children),
                        .variables = {variables.begin(), variables.end()}});
    }
    if (frame.kind == Kind::kEquivalent) {
      return tree_.Add({.kind = frame.kind, .children = std::move(children)});
    }
    const Kind neutral = frame.kind == Kind::kAnd ? Kind::kTrue : Kind::kFalse;
    const auto is = [this](Kind kind) {
      return [this, kind](Id id) { return tree_.nodes[id].kind == kind; };
    };
    const auto deciding = std::find_if(children.begin(), children.end(), is(Dual(neutral)));
    if (deciding != children.end()) return *deciding;
    children.erase(std::remove_if(children.begin(), children.end(), is(neutral)), children.end());
    if (children.empty()) return tree_.Add({.kind = neutral});
    if (children.size() == 1) return children[0];
    return tree_.Add({.kind = frame.kind, .children = std::move(children)});
  }

  NormalTree& tree_;
  std::vector<Frame> open_;
  std::vector<Id> values_;
};

}  // namespace

NormalTree NormalTree::Of(const Formula& formula, bool positive) {
  NormalTree tree;
  tree.root = Builder(tree).Build(formula, positive);
  std::vector<Variable> free = tree.FreeVariables(tree.root);
  if (!free.empty()) {
    tree.root = tree.Add({.kind = positive ? Kind::kForall : Kind::kExists,
                          .children = {tree.root},
                          .variables = std::move(free)});
  }
  return tree;
}

Id NormalTree::Add(Node node) {
  nodes.push_back(std::move(node));
  return static_cast<Id>(nodes.size() - 1);
}

Id NormalTree::AddLiteral(Atom atom, bool positive) {
  own_atoms.push_back(std::move(atom));
  return Add({.kind = Kind::kLiteral, .positive = positive, .atom = &own_atoms.back()});
}

std::vector<Id> NormalTree::Below(Id id) const {
  std::vector<Id> order;
  std::vector<Id> pending = {id};
  while (!pending.empty()) {
    const Id next = pending.back();
    pending.pop_back();
    order.push_back(next);
    const auto& children = nodes[next].children;
    pending.insert(pending.end(), children.rbegin(), children.rend());
  }
  return order;
}

std::vector<Variable> NormalTree::FreeVariables(Id id) const {
  std::vector<Variable> occurring;
  std::vector<Variable> quantified;
  for (const Id each : Below(id)) {
    const Node& node = nodes[each];
    if (node.kind == Kind::kLiteral) CollectVariables(*node.atom, occurring);
    quantified.insert(quantified.end(), node.variables.begin(), node.variables.end());
  }
  SortUnique(occurring);
  SortUnique(quantified);
  std::vector<Variable> free;
  std::set_difference(occurring.begin(), occurring.end(), quantified.begin(), quantified.end(),
                      std::back_inserter(free));
  return free;
}

void CollectVariables(const Atom& atom, std::vector<Variable>& variables) {
  std::vector<const Term*> pending;
  const auto visit = [&](std::span<const Term> terms) {
    for (const Term& term : terms) {
      if (term.is_variable()) {
        variables.push_back(term.variable());
      } else if (!term.is_ground()) {
        pending.push_back(&term);
      }
    }
  };
  visit(atom.arguments());
  while (!pending.empty()) {
    const Term* term = pending.back();
    pending.pop_back();
    visit(term->arguments());
  }
}

void SortUnique(std::vector<Variable>& variables) {
  std::sort(variables.begin(), variables.end());
  variables.erase(std::unique(variables.begin(), variables.end()), variables.end());
}

}  // namespace latchwork::logic

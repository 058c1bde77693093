// SPDX-License-Identifier: BSD-3-Clause
#include "core/logic/name_subformulas.h"

#include <algorithm>
#include <utility>

namespace latchwork::logic {

namespace {

using Kind = NormalTree::Kind;
using Id = NormalTree::Id;
using Node = NormalTree::Node;

/// How many clauses and literals a formula gives. Doubles, because they may grow without bound.
struct Cost {
  double clauses = 1;
  double literals = 1;
};

Cost Sum(const Cost& a, const Cost& b) { return {a.clauses + b.clauses, a.literals + b.literals}; }

Cost Product(const Cost& a, const Cost& b) {
  return {a.clauses * b.clauses, a.literals * b.clauses + b.literals * a.clauses};
}

struct Estimate {
  Cost positive;
  Cost negative;
  double size = 1;

  bool is_complex() const { return positive.clauses > 1 || negative.clauses > 1; }
};

class Namer {
 public:
  Namer(NormalTree& tree, FreeVariableTable* free, std::size_t limit, SymbolTable& symbols)
      : tree_(tree), free_(free), limit_(static_cast<double>(limit)), symbols_(symbols) {}

  std::vector<SubformulaName> Run() {
    std::vector<Id> order = tree_.Below(tree_.root);
    estimates_.resize(tree_.nodes.size());
    in_both_.resize(tree_.nodes.size());
    for (const Id id : order) {
      const bool both = in_both_[id] || tree_.nodes[id].kind == Kind::kEquivalent;
      for (const Id child : tree_.nodes[id].children) in_both_[child] = both;
    }
    std::reverse(order.begin(), order.end());
    for (const Id id : order) Visit(id);
    return std::move(names_);
  }

 private:
  void Visit(Id id) {
    switch (tree_.nodes[id].kind) {
      case Kind::kAnd:
      case Kind::kOr:
        VisitJunction(id);
        break;
      case Kind::kEquivalent:
        VisitEquivalence(id);
        break;
      case Kind::kForall:
      case Kind::kExists:
        estimates_[id] = estimates_[tree_.nodes[id].children[0]];
        break;
      default:
        break;
    }
  }

  /// In the polarity in which the node is a disjunction.
  Cost& Distributed(Id id, Kind kind) {
    return kind == Kind::kOr ? estimates_[id].positive : estimates_[id].negative;
  }

  void VisitJunction(Id id) {
    const Kind kind = tree_.nodes[id].kind;
    if (kind == Kind::kOr || in_both_[id]) LimitDistribution(id, kind);
    Estimate estimate{{}, {}, 1};
    Cost sum{0, 0};
    Cost product{1, 0};
    for (const Id child : tree_.nodes[id].children) {
      const Estimate& of = estimates_[child];
      const bool is_or = kind == Kind::kOr;
      sum = Sum(sum, is_or ? of.negative : of.positive);
      product = Product(product, is_or ? of.positive : of.negative);
      estimate.size += of.size;
    }
    estimate.positive = kind == Kind::kOr ? product : sum;
    estimate.negative = kind == Kind::kOr ? sum : product;
    estimates_[id] = estimate;
  }

  void LimitDistribution(Id id, Kind kind) {
    std::vector<Id> complex;
    Cost product{1, 0};
    double size = 1;
    for (const Id child : tree_.nodes[id].children) {
      size += estimates_[child].size;
      if (Distributed(child, kind).clauses > 1) {
        complex.push_back(child);
      } else {
        product = Product(product, Distributed(child, kind));
      }
    }
    std::stable_sort(complex.begin(), complex.end(), [&](Id a, Id b) {
      return Distributed(a, kind).clauses < Distributed(b, kind).clauses;
    });
    for (const Id child : complex) {
      const Cost next = Product(product, Distributed(child, kind));
      const bool is_first = product.clauses <= 1;
      if ((next.clauses > limit_ && !is_first) || next.literals > LiteralLimit(size)) {
        Name(child);
        product = Product(product, Cost());
      } else {
        product = next;
      }
    }
  }

  static double LiteralLimit(double size) { return 8 * size + 1000; }

  void VisitEquivalence(Id id) {
    const Id a = tree_.nodes[id].children[0];
    const Id b = tree_.nodes[id].children[1];
    estimates_[id] = EstimateEquivalence(id);
    while (IsTooLarge(id)) {
      const bool name_a =
          estimates_[a].is_complex() && (!estimates_[b].is_complex() || Clauses(a) > Clauses(b));
      Name(name_a ? a : b);
      estimates_[id] = EstimateEquivalence(id);
    }
  }

  double Clauses(Id id) const {
    return estimates_[id].positive.clauses + estimates_[id].negative.clauses;
  }

  Estimate EstimateEquivalence(Id id) const {
    const Estimate& a = estimates_[tree_.nodes[id].children[0]];
    const Estimate& b = estimates_[tree_.nodes[id].children[1]];
    return {Sum(Product(a.negative, b.positive), Product(a.positive, b.negative)),
            Sum(Product(a.positive, b.positive), Product(a.negative, b.negative)),
            a.size + b.size + 1};
  }

  /// Whether a name would help: something complex is copied, and the outcome is beyond the limits.
  bool IsTooLarge(Id id) const {
    const Estimate& estimate = estimates_[id];
    const bool a = estimates_[tree_.nodes[id].children[0]].is_complex();
    const bool b = estimates_[tree_.nodes[id].children[1]].is_complex();
    if (!a && !b) return false;
    const double literals = estimate.positive.literals + estimate.negative.literals;
    if (literals > 4 * LiteralLimit(estimate.size)) return true;
    if (in_both_[id]) return Clauses(id) > limit_;
    return a && b && estimate.positive.clauses > limit_;
  }

  /// Puts a fresh atom of its free variables in the place of a formula.
  void Name(Id id) {
    const std::vector<Variable> variables = free_ ? (*free_)[id] : tree_.FreeVariables(id);
    std::vector<Term> arguments;
    arguments.reserve(variables.size());
    for (const Variable variable : variables) arguments.push_back(Term::Var(variable));
    const Id name = tree_.AddLiteral(Atom(symbols_.Fresh("def_"), arguments), true);
    const Id body = tree_.Add(std::move(tree_.nodes[id]));
    tree_.nodes[id] = tree_.nodes[name];
    names_.push_back({name, body, in_both_[id]});
    estimates_[id] = Estimate();
    if (free_ == nullptr) return;
    free_->push_back(variables);
    free_->push_back(variables);
  }

  NormalTree& tree_;
  FreeVariableTable* free_;
  const double limit_;
  SymbolTable& symbols_;
  std::vector<Estimate> estimates_;
  std::vector<bool> in_both_;
  std::vector<SubformulaName> names_;
};

}  // namespace

std::vector<SubformulaName> NameSubformulas(NormalTree& tree, FreeVariableTable* free,
                                            std::size_t limit, SymbolTable& symbols) {
  return Namer(tree, free, limit, symbols).Run();
}

}  // namespace latchwork::logic

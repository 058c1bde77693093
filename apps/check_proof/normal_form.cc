// SPDX-License-Identifier: BSD-3-Clause
#include "apps/check_proof/normal_form.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace latchwork::check_proof {
namespace {

using logic::Atom;
using logic::Formula;
using logic::Term;
using logic::Variable;
using Kind = Tree::Kind;

constexpr std::size_t kDeepest = 1000;
constexpr std::size_t kLargest = 200'000;
constexpr std::size_t kDeepestTerm = 2000;

void CollectVariables(const Term& term, std::set<Variable>& variables) {
  if (term.is_variable()) variables.insert(term.variable());
  if (term.is_ground()) return;
  for (const Term& argument : term.arguments()) CollectVariables(argument, variables);
}

std::set<Variable> FreeSet(const Tree& tree) {
  std::set<Variable> free;
  if (tree.kind == Kind::kLiteral) {
    for (const Term& argument : tree.literal.atom.arguments()) CollectVariables(argument, free);
  }
  for (const Tree& child : tree.children) free.merge(FreeSet(child));
  for (const Variable variable : tree.variables) free.erase(variable);
  return free;
}

}  // namespace

bool IsShallow(const Atom& atom) {
  std::vector<std::pair<const Term*, std::size_t>> visits;
  for (const Term& argument : atom.arguments()) visits.emplace_back(&argument, 1);
  while (!visits.empty()) {
    const auto [term, depth] = visits.back();
    visits.pop_back();
    if (depth > kDeepestTerm) return false;
    for (const Term& argument : term->arguments()) visits.emplace_back(&argument, depth + 1);
  }
  return true;
}

Term Substitute(const Term& term, const std::map<Variable, Term>& by) {
  if (term.is_variable()) {
    const auto found = by.find(term.variable());
    return found == by.end() ? term : found->second;
  }
  if (term.is_ground()) return term;
  std::vector<Term> arguments;
  for (const Term& argument : term.arguments()) arguments.push_back(Substitute(argument, by));
  return Term::Compound(term.symbol(), std::move(arguments));
}

Atom Substitute(const Atom& atom, const std::map<Variable, Term>& by) {
  std::vector<Term> arguments;
  for (const Term& argument : atom.arguments()) arguments.push_back(Substitute(argument, by));
  return {atom.predicate(), arguments};
}

std::optional<Tree> Normalizer::Normalize(const Formula& formula, bool positive) {
  Tree tree;
  if (!Build(formula, positive, {}, tree)) return std::nullopt;
  return tree;
}

bool Normalizer::Build(const Formula& formula, bool positive, const Renaming& renaming,
                       Tree& tree) {
  if (++size_ > kLargest || depth_ >= kDeepest) return false;
  ++depth_;
  bool done = true;
  switch (formula.kind()) {
    case Formula::Kind::kTrue:
    case Formula::Kind::kFalse:
      tree.kind = (formula.kind() == Formula::Kind::kTrue) == positive ? Kind::kTrue : Kind::kFalse;
      break;
    case Formula::Kind::kAtom:
      done = BuildAtom(formula.atom(), positive, renaming, tree);
      break;
    case Formula::Kind::kNot:
      done = Build(formula.children()[0], !positive, renaming, tree);
      break;
    case Formula::Kind::kAnd:
      done = BuildJunction(positive ? Kind::kAnd : Kind::kOr, formula, positive, renaming, tree);
      break;
    case Formula::Kind::kOr:
    case Formula::Kind::kImplies:
      done = BuildJunction(positive ? Kind::kOr : Kind::kAnd, formula, positive, renaming, tree);
      break;
    case Formula::Kind::kEquivalent:
      done = BuildEquivalence(formula, positive, renaming, tree);
      break;
    case Formula::Kind::kForall:
    case Formula::Kind::kExists:
      done = BuildQuantifier(formula, positive, renaming, tree);
      break;
  }
  --depth_;
  return done;
}

bool Normalizer::BuildAtom(const Atom& atom, bool positive, const Renaming& renaming, Tree& tree) {
  if (!IsShallow(atom)) return false;
  size_ += atom.arity();
  const auto definition = definitions_.find(NameOf(atom));
  if (definition == definitions_.end()) {
    tree.kind = Kind::kLiteral;
    tree.literal = {positive, Substitute(atom, renaming)};
    return true;
  }
  Renaming parameters;
  for (std::size_t i = 0; i < atom.arity(); ++i) {
    parameters.emplace(definition->second.parameters[i], Substitute(atom.argument(i), renaming));
  }
  return Build(definition->second.body, positive, parameters, tree);
}

bool Normalizer::BuildJunction(Kind kind, const Formula& formula, bool positive,
                               const Renaming& renaming, Tree& tree) {
  tree.kind = kind;
  const auto children = formula.children();
  for (std::size_t i = 0; i < children.size(); ++i) {
    const bool is_premise = formula.kind() == Formula::Kind::kImplies && i == 0;
    Tree child;
    if (!Build(children[i], positive != is_premise, renaming, child)) return false;
    tree.children.push_back(std::move(child));
  }
  return true;
}

/// (~a | b) & (a | ~b); negated: (a | b) & (~a | ~b).
bool Normalizer::BuildEquivalence(const Formula& formula, bool positive, const Renaming& renaming,
                                  Tree& tree) {
  tree.kind = Kind::kAnd;
  for (const bool is_first : {true, false}) {
    Tree half;
    half.kind = Kind::kOr;
    half.children.resize(2);
    if (!Build(formula.children()[0], is_first != positive, renaming, half.children[0]) ||
        !Build(formula.children()[1], is_first, renaming, half.children[1])) {
      return false;
    }
    tree.children.push_back(std::move(half));
  }
  return true;
}

bool Normalizer::BuildQuantifier(const Formula& formula, bool positive, const Renaming& renaming,
                                 Tree& tree) {
  const bool is_universal = (formula.kind() == Formula::Kind::kForall) == positive;
  tree.kind = is_universal ? Kind::kForall : Kind::kExists;
  Renaming inner = renaming;
  for (const Variable variable : formula.variables()) {
    tree.variables.push_back(next_variable_);
    inner.insert_or_assign(variable, Term::Var(next_variable_++));
  }
  size_ += inner.size();
  tree.children.resize(1);
  return Build(formula.children()[0], positive, inner, tree.children[0]);
}

std::vector<Variable> FreeVariables(const Tree& tree) {
  const auto free = FreeSet(tree);
  return {free.begin(), free.end()};
}

namespace {

bool IsFree(Variable variable, const Tree& tree) { return FreeSet(tree).contains(variable); }

void FlattenJunction(Tree& tree) {
  const Kind neutral = tree.kind == Kind::kAnd ? Kind::kTrue : Kind::kFalse;
  const Kind deciding = tree.kind == Kind::kAnd ? Kind::kFalse : Kind::kTrue;
  std::vector<Tree> flat;
  for (Tree& child : tree.children) {
    if (child.kind == deciding) {
      tree = Tree{.kind = deciding, .literal = {}, .children = {}, .variables = {}};
      return;
    }
    if (child.kind == neutral) continue;
    if (child.kind == tree.kind) {
      std::move(child.children.begin(), child.children.end(), std::back_inserter(flat));
    } else {
      flat.push_back(std::move(child));
    }
  }
  if (flat.size() == 1) {
    Tree only = std::move(flat[0]);
    tree = std::move(only);
    return;
  }
  tree.children = std::move(flat);
  if (tree.children.empty()) tree.kind = neutral;
}

void Wrap(Kind kind, Variable variable, Tree& tree) {
  Tree inner = std::move(tree);
  tree = Tree{.kind = kind, .literal = {}, .children = {}, .variables = {variable}};
  tree.children.push_back(std::move(inner));
}

void Push(Kind kind, Variable variable, Tree& tree) {
  if (!IsFree(variable, tree)) return;
  Tree* place = &tree;
  Tree* block = nullptr;  // The like quantifier right above `place`.
  while (place->kind == Kind::kAnd || place->kind == Kind::kOr || place->kind == kind) {
    Tree* only = nullptr;
    std::size_t count = 0;
    for (Tree& child : place->children) {
      if (!IsFree(variable, child)) continue;
      only = &child;
      ++count;
    }
    if (count > 1) break;
    block = place->kind == kind ? place : nullptr;
    place = only;
  }
  if (block != nullptr) {
    block->variables.push_back(variable);
  } else {
    Wrap(kind, variable, *place);
  }
}

/// Of literals or a conjunction: the conjunction of as many disjunctions. Nothing for others.
std::optional<Tree> Distributed(const Tree& tree) {
  if (tree.kind != Kind::kOr) return std::nullopt;
  const auto& children = tree.children;
  const auto is_and = [](const Tree& child) { return child.kind == Kind::kAnd; };
  const auto is_simple = [&](const Tree& child) {
    return child.kind == Kind::kLiteral || is_and(child);
  };
  if (std::ranges::count_if(children, is_and) != 1) return std::nullopt;
  if (!std::ranges::all_of(children, is_simple)) return std::nullopt;
  Tree conjunction{Kind::kAnd, {}, {}, {}};
  for (const Tree& part : std::ranges::find_if(children, is_and)->children) {
    Tree& disjunction = conjunction.children.emplace_back(Tree{Kind::kOr, {}, {part}, {}});
    std::ranges::remove_copy_if(children, std::back_inserter(disjunction.children), is_and);
  }
  return conjunction;
}

void CollectConjuncts(const Tree& tree, std::vector<Variable>& prefix,
                      std::vector<Tree>& conjuncts) {
  if (tree.kind == Kind::kForall || tree.kind == Kind::kAnd) {
    const std::size_t outer = prefix.size();
    prefix.insert(prefix.end(), tree.variables.begin(), tree.variables.end());
    for (const Tree& child : tree.children) CollectConjuncts(child, prefix, conjuncts);
    prefix.resize(outer);
    return;
  }
  Tree& conjunct = conjuncts.emplace_back(tree);
  const auto free = FreeSet(tree);
  for (const Variable variable : prefix) {
    if (free.contains(variable)) Wrap(Kind::kForall, variable, conjunct);
  }
  MoveQuantifiersInwards(conjunct);
}

/// Compares trees; variables are bound one to one across both, as every quantifier has its own.
class VariantCheck {
 public:
  bool IsSame(const Tree& a, const Tree& b) {
    if (++steps_ > kMostSteps || a.kind != b.kind || a.children.size() != b.children.size() ||
        a.variables.size() != b.variables.size()) {
      return false;
    }
    if (a.kind == Kind::kLiteral) return IsSame(a.literal, b.literal);
    if (!HasSameChildren(a, b)) return false;
    // A pair that met in the leaves must have met in the quantifiers.
    return std::all_of(a.variables.begin(), a.variables.end(), [&](Variable variable) {
      const auto met = there_.find(variable);
      return met == there_.end() ||
             std::find(b.variables.begin(), b.variables.end(), met->second) != b.variables.end();
    });
  }

  bool is_spent() const { return steps_ > kMostSteps; }

 private:
  static constexpr std::size_t kMostSteps = 5'000'000;

  /// In their order, or else each with the first that it fits.
  bool HasSameChildren(const Tree& a, const Tree& b) {
    const std::size_t mark = bound_.size();
    bool in_order = true;
    for (std::size_t i = 0; in_order && i < a.children.size(); ++i) {
      in_order = IsSame(a.children[i], b.children[i]);
    }
    if (in_order) return true;
    Undo(mark);
    std::vector<bool> taken(b.children.size());
    return std::all_of(a.children.begin(), a.children.end(), [&](const Tree& child) {
      return std::any_of(b.children.begin(), b.children.end(), [&](const Tree& other) {
        const auto index = static_cast<std::size_t>(&other - b.children.data());
        if (taken[index]) return false;
        const std::size_t before = bound_.size();
        taken[index] = IsSame(child, other);
        if (!taken[index]) Undo(before);
        return static_cast<bool>(taken[index]);
      });
    });
  }

  bool IsSame(const logic::Literal& a, const logic::Literal& b) {
    if (a.positive != b.positive || NameOf(a.atom) != NameOf(b.atom)) return false;
    for (std::size_t i = 0; i < a.atom.arity(); ++i) {
      if (!IsSame(a.atom.argument(i), b.atom.argument(i))) return false;
    }
    return true;
  }

  bool IsSame(const Term& a, const Term& b) {
    ++steps_;
    if (a.is_variable() && b.is_variable()) return Bind(a.variable(), b.variable());
    if (a.kind() != b.kind()) return false;
    if (a.kind() != Term::Kind::kCompound) return a == b;
    const auto arguments = a.arguments();
    const auto others = b.arguments();
    if (a.symbol() != b.symbol() || arguments.size() != others.size()) return false;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (!IsSame(arguments[i], others[i])) return false;
    }
    return true;
  }

  bool Bind(Variable a, Variable b) {
    const auto to = there_.find(a);
    const auto from = back_.find(b);
    if (to != there_.end() || from != back_.end()) {
      return to != there_.end() && from != back_.end() && to->second == b && from->second == a;
    }
    there_.emplace(a, b);
    back_.emplace(b, a);
    bound_.push_back(a);
    return true;
  }

  void Undo(std::size_t mark) {
    for (; bound_.size() > mark; bound_.pop_back()) {
      const auto place = there_.find(bound_.back());
      back_.erase(place->second);
      there_.erase(place);
    }
  }

  std::map<Variable, Variable> there_;
  std::map<Variable, Variable> back_;
  std::vector<Variable> bound_;
  std::size_t steps_ = 0;
};

}  // namespace

void MoveQuantifiersInwards(Tree& tree) {
  for (Tree& child : tree.children) MoveQuantifiersInwards(child);
  if (tree.kind == Kind::kAnd || tree.kind == Kind::kOr) return FlattenJunction(tree);
  if (tree.kind != Kind::kForall && tree.kind != Kind::kExists) return;
  const Kind kind = tree.kind;
  const std::vector<Variable> variables = std::move(tree.variables);
  Tree inner = std::move(tree.children[0]);
  tree = std::move(inner);
  for (const Variable variable : variables) Push(kind, variable, tree);
}

std::vector<Tree> ConjunctsOf(const Tree& tree) {
  std::vector<Tree> conjuncts;
  std::vector<Variable> prefix;
  CollectConjuncts(tree, prefix, conjuncts);
  return conjuncts;
}

std::vector<Tree> PartsOf(const Tree& conjunct) {
  std::vector<Variable> prefix;
  const Tree* inner = &conjunct;
  for (; inner->kind == Kind::kForall; inner = &inner->children[0]) {
    prefix.insert(prefix.end(), inner->variables.begin(), inner->variables.end());
  }
  const std::optional<Tree> junction = Distributed(*inner);
  if (!junction) return {conjunct};
  std::vector<Tree> parts;
  CollectConjuncts(*junction, prefix, parts);
  return parts;
}

std::optional<bool> IsVariant(const Tree& a, const Tree& b) {
  VariantCheck check;
  if (check.IsSame(a, b)) return true;
  if (check.is_spent()) return std::nullopt;
  return false;
}

}  // namespace latchwork::check_proof

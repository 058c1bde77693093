// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/formula_pairs.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace latchwork::pttp {
namespace {

using logic::Formula;
using logic::Term;
using logic::Variable;
using Kind = Formula::Kind;

/// What works on deeper formulas may not recurse.
constexpr std::size_t kDeepest = 200;

struct Signed {
  const Formula* formula;
  bool positive;
};

Signed WithoutNegations(Signed part) {
  for (; part.formula->kind() == Kind::kNot; part.positive = !part.positive) {
    part.formula = &part.formula->children()[0];
  }
  return part;
}

/// Of the negation normal form.
Kind NormalKind(const Signed& part) {
  switch (part.formula->kind()) {
    case Kind::kAnd:
      return part.positive ? Kind::kAnd : Kind::kOr;
    case Kind::kOr:
    case Kind::kImplies:
      return part.positive ? Kind::kOr : Kind::kAnd;
    case Kind::kForall:
      return part.positive ? Kind::kForall : Kind::kExists;
    case Kind::kExists:
      return part.positive ? Kind::kExists : Kind::kForall;
    default:
      return part.formula->kind();
  }
}

void CollectParts(const Signed& whole, Kind kind, std::vector<Signed>& parts) {
  const auto children = whole.formula->children();
  for (std::size_t i = 0; i < children.size(); ++i) {
    const bool is_premise = whole.formula->kind() == Kind::kImplies && i == 0;
    const Signed part = WithoutNegations({&children[i], whole.positive != is_premise});
    if (NormalKind(part) == kind) {
      CollectParts(part, kind, parts);
    } else {
      parts.push_back(part);
    }
  }
}

/// The parts of nested junctions of the same kind.
void CollectLike(const Formula& whole, std::vector<const Formula*>& parts) {
  for (const Formula& child : whole.children()) {
    if (child.kind() == whole.kind()) {
      CollectLike(child, parts);
    } else {
      parts.push_back(&child);
    }
  }
}

/// Goes below a block of quantifiers of the kind; gives their variables.
std::set<Variable> Descend(Kind kind, Signed& part) {
  std::set<Variable> variables;
  while (NormalKind(part) == kind) {
    const auto bound = part.formula->variables();
    variables.insert(bound.begin(), bound.end());
    part = WithoutNegations({&part.formula->children()[0], part.positive});
  }
  return variables;
}

class Pairing {
 public:
  explicit Pairing(const BodyOf& body_of) : body_of_(body_of) {}

  std::optional<std::size_t> Add(const Signed& whole, const Formula& normal) {
    const Signed said = WithoutNegations(whole);
    FormulaPair pair{said.formula, said.positive, &normal, {}, 0, 0, false};
    if (++nesting_ > kDeepest || !AddParts(said, normal, pair)) return std::nullopt;
    --nesting_;
    for (const std::size_t part : pair.parts) {
      pair.size += pairs[part].size;
      pair.depth = std::max(pair.depth, pairs[part].depth);
    }
    const bool quantifies = !pair.is_name && !normal.variables().empty();
    if (quantifies || pair.parts.empty()) ++pair.size;
    if (quantifies) ++pair.depth;
    pairs.push_back(std::move(pair));
    return pairs.size() - 1;
  }

  std::vector<FormulaPair> pairs;

 private:
  bool AddParts(const Signed& said, const Formula& normal, FormulaPair& pair) {
    const Formula* body = normal.kind() == Kind::kAtom ? body_of_(normal.atom()) : nullptr;
    pair.is_name = body != nullptr;
    if (body != nullptr) return AddPart(said, *body, pair);
    const Kind kind = NormalKind(said);
    if (kind == Kind::kAtom) return IsLiteral(said, normal);
    if (kind != normal.kind()) return false;
    if (kind == Kind::kAnd || kind == Kind::kOr) return AddJunction(said, normal, pair);
    return (kind == Kind::kForall || kind == Kind::kExists) && AddQuantifier(said, normal, pair);
  }

  bool AddPart(const Signed& said, const Formula& normal, FormulaPair& pair) {
    const auto part = Add(said, normal);
    if (part) pair.parts.push_back(*part);
    return part.has_value();
  }

  static bool IsLiteral(const Signed& said, const Formula& normal) {
    const Formula* atom = &normal;
    if (!said.positive) atom = normal.kind() == Kind::kNot ? &normal.children()[0] : nullptr;
    return atom != nullptr && atom->kind() == Kind::kAtom && atom->atom() == said.formula->atom();
  }

  bool AddJunction(const Signed& said, const Formula& normal, FormulaPair& pair) {
    std::vector<Signed> parts;
    std::vector<const Formula*> others;
    CollectParts(said, normal.kind(), parts);
    CollectLike(normal, others);
    if (parts.size() != others.size()) return false;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!AddPart(parts[i], *others[i], pair)) return false;
    }
    return true;
  }

  bool AddQuantifier(Signed said, const Formula& normal, FormulaPair& pair) {
    std::set<Variable> others;
    const Formula* inner = &normal;
    for (; inner->kind() == normal.kind(); inner = &inner->children()[0]) {
      others.insert(inner->variables().begin(), inner->variables().end());
    }
    return Descend(normal.kind(), said) == others && AddPart(said, *inner, pair);
  }

  const BodyOf& body_of_;
  std::size_t nesting_ = 0;
};

bool IsNestedDeeply(const Formula& formula) {
  std::vector<std::pair<const Formula*, std::size_t>> visits{{&formula, 1}};
  while (!visits.empty()) {
    const auto [current, depth] = visits.back();
    visits.pop_back();
    if (depth > kDeepest) return true;
    for (const Formula& child : current->children()) visits.emplace_back(&child, depth + 1);
  }
  return false;
}

void CollectVariables(const Term& term, std::set<Variable>& variables) {
  if (term.is_variable()) variables.insert(term.variable());
  if (term.is_ground()) return;
  for (const Term& argument : term.arguments()) CollectVariables(argument, variables);
}

}  // namespace

std::optional<std::vector<FormulaPair>> PairFormulas(const Formula& said, bool positive,
                                                     const Formula& normal, const BodyOf& body_of) {
  if (IsNestedDeeply(said) || IsNestedDeeply(normal)) return std::nullopt;
  Pairing pairing(body_of);
  if (!pairing.Add({&said, positive}, normal)) return std::nullopt;
  return std::move(pairing.pairs);
}

Formula Said(const FormulaPair& pair) {
  return pair.positive ? *pair.said : Formula::Not(*pair.said);
}

std::vector<Variable> FreeVariables(const Formula& formula) {
  std::set<Variable> occurring;
  std::set<Variable> bound;
  std::vector<const Formula*> visits{&formula};
  while (!visits.empty()) {
    const Formula& current = *visits.back();
    visits.pop_back();
    bound.insert(current.variables().begin(), current.variables().end());
    if (current.kind() == Kind::kAtom) {
      for (const Term& term : current.atom().arguments()) CollectVariables(term, occurring);
    }
    for (const Formula& child : current.children()) visits.push_back(&child);
  }
  std::vector<Variable> free;
  std::set_difference(occurring.begin(), occurring.end(), bound.begin(), bound.end(),
                      std::back_inserter(free));
  return free;
}

Formula Replaced(const Formula& formula, const Replacements& by) {
  if (const auto found = by.find(&formula); found != by.end()) return found->second;
  std::vector<Formula> children;
  for (const Formula& child : formula.children()) children.push_back(Replaced(child, by));
  return formula.With(std::move(children));
}

Formula Closed(Formula formula) {
  std::vector<Variable> free = FreeVariables(formula);
  return free.empty() ? formula : Formula::Forall(std::move(free), std::move(formula));
}

}  // namespace latchwork::pttp

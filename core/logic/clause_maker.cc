// SPDX-License-Identifier: BSD-3-Clause
#include "core/logic/clause_maker.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/logic/rebuild_term.h"

namespace latchwork::logic {

namespace {

using Kind = NormalTree::Kind;
using Id = NormalTree::Id;
using Node = NormalTree::Node;

}  // namespace

ClauseMaker::ClauseMaker(const NormalTree& tree, const FreeVariableTable* free,
                         const std::vector<std::string>& variable_names, SymbolTable& symbols,
                         WorkMeter& work, ClauseRecorder* recorder)
    : tree_(tree),
      free_(free),
      variable_names_(variable_names),
      symbols_(symbols),
      work_(work),
      recorder_(recorder) {}

void ClauseMaker::Make(const std::vector<Item>& disjunction, const std::vector<Variable>& variables,
                       const Clause& pattern, std::vector<Clause>& clauses) {
  scope_.clear();
  literals_.clear();
  sources_.clear();
  numbers_.clear();
  numbered_.clear();
  for (const Variable variable : variables) FreshVariable(variable);
  if (recorder_ != nullptr) recorder_->Begin();
  Expand(disjunction);
  if (recorder_ != nullptr) {
    recorder_->Junction(true, disjunction.size());
    recorder_->Quantifier(true, variables, FreshFrom(0, variables.size()));
  }
  for (const LiteralIndices& indices : done_) {
    if (work_.is_spent()) return;
    if (auto clause = Finish(indices, pattern)) clauses.push_back(*std::move(clause));
  }
}

void ClauseMaker::Expand(const std::vector<Item>& disjunction) {
  done_.assign(1, {});
  for (const Item& part : disjunction) {
    const std::size_t middle = done_.size();
    Begin(part);
    while (!open_.empty() && !work_.is_spent()) {
      Frame& frame = open_.back();
      if (frame.next > 0 && frame.is_disjunction) Distribute(frame.first, frame.middle);
      if (frame.next == ChildCount(frame)) {
        if (recorder_ != nullptr) Record(frame);
        scope_.resize(frame.scope);
        open_.pop_back();
        continue;
      }
      frame.middle = done_.size();
      Begin(ChildItem(frame, frame.next++));
    }
    open_.clear();
    Distribute(0, middle);
  }
}

void ClauseMaker::Record(const Frame& frame) {
  const Node& node = tree_.nodes[frame.item.id];
  if (node.kind != Kind::kForall && node.kind != Kind::kExists) {
    return recorder_->Junction(frame.is_disjunction, node.children.size());
  }
  const bool is_universal = (node.kind == Kind::kForall) == frame.item.positive;
  const std::size_t count = is_universal ? node.variables.size() : 0;
  recorder_->Quantifier(is_universal, node.variables, FreshFrom(frame.scope, count));
}

std::vector<Variable> ClauseMaker::FreshFrom(std::size_t scope, std::size_t count) const {
  std::vector<Variable> fresh;
  for (std::size_t i = 0; i < count; ++i) fresh.push_back(scope_[scope + i].variable());
  return fresh;
}

bool ClauseMaker::IsDisjunction(const Item& item) const {
  const Kind kind = tree_.nodes[item.id].kind;
  if (kind == Kind::kEquivalent) return item.half != Half::kNone;
  return kind == (item.positive ? Kind::kOr : Kind::kAnd);
}

std::size_t ClauseMaker::ChildCount(const Frame& frame) const {
  return tree_.nodes[frame.item.id].children.size();
}

/// a <=> b is (~a | b) & (a | ~b); its negation is (a | b) & (~a | ~b).
ClauseMaker::Item ClauseMaker::ChildItem(const Frame& frame, std::size_t index) const {
  const Item& item = frame.item;
  const Node& node = tree_.nodes[item.id];
  if (node.kind != Kind::kEquivalent) return {node.children[index], item.positive};
  if (item.half == Half::kNone) {
    return {item.id, item.positive, index == 0 ? Half::kFirst : Half::kSecond};
  }
  const bool is_first = item.half == Half::kFirst;
  return {node.children[index], index == 0 ? is_first != item.positive : is_first};
}

void ClauseMaker::Begin(const Item& item) {
  const Node& node = tree_.nodes[item.id];
  switch (node.kind) {
    case Kind::kTrue:
    case Kind::kFalse:
      if ((node.kind == Kind::kTrue) != item.positive) done_.emplace_back();
      if (recorder_ != nullptr) recorder_->Constant((node.kind == Kind::kTrue) == item.positive);
      return;
    case Kind::kLiteral:
      return AddLiteral(node, node.positive == item.positive);
    default:
      break;
  }
  const bool is_disjunction = IsDisjunction(item);
  open_.push_back({item, is_disjunction, done_.size(), done_.size(), scope_.size()});
  BindVariables(item);
  if (!is_disjunction) return;
  // The neutral clause of a disjunction, which the children extend.
  done_.emplace_back();
}

void ClauseMaker::BindVariables(const Item& item) {
  const Node& node = tree_.nodes[item.id];
  const bool is_universal = (node.kind == Kind::kForall) == item.positive;
  for (const Variable variable : node.variables) {
    if (is_universal) {
      FreshVariable(variable);
      continue;
    }
    const Term term = SkolemTerm(item.id);
    if (bindings_.size() <= variable) bindings_.resize(variable + std::size_t{1});
    bindings_[variable] = term;
  }
}

Term ClauseMaker::FreshVariable(Variable source) {
  Term fresh = Term::Var(static_cast<Variable>(sources_.size()));
  sources_.push_back(source);
  scope_.push_back(fresh);
  if (bindings_.size() <= source) bindings_.resize(source + std::size_t{1});
  bindings_[source] = fresh;
  return fresh;
}

Term ClauseMaker::SkolemTerm(Id quantifier) {
  std::vector<Term> arguments = free_ == nullptr ? scope_ : SkolemArguments(quantifier);
  work_.Spend(arguments.size() + 1);
  const Symbol symbol = symbols_.Fresh("sk_");
  if (recorder_ != nullptr) recorder_->Skolem(symbol);
  if (arguments.empty()) return Term::Constant(symbol);
  return Term::Compound(symbol, std::move(arguments));
}

/// The universal variables that the quantified formula depends on. Of a conjunction or disjunction
/// only the parts that hold the variable count: the others could be moved out of its scope.
std::vector<Term> ClauseMaker::SkolemArguments(Id quantifier) {
  const Node& node = tree_.nodes[quantifier];
  const Node& body = tree_.nodes[node.children[0]];
  std::vector<Variable> free;
  if (body.kind == Kind::kAnd || body.kind == Kind::kOr) {
    for (const Id child : body.children) {
      const auto& of_child = (*free_)[child];
      if (!std::binary_search(of_child.begin(), of_child.end(), node.variables[0])) continue;
      free.insert(free.end(), of_child.begin(), of_child.end());
    }
    SortUnique(free);
  } else {
    free = (*free_)[node.children[0]];
  }
  std::vector<Term> arguments;
  for (const Variable each : free) {
    if (each == node.variables[0]) continue;
    const Term& bound = *bindings_[each];
    const auto universal =
        bound.is_variable() ? std::span<const Term>(&bound, 1) : bound.arguments();
    arguments.insert(arguments.end(), universal.begin(), universal.end());
  }
  std::sort(arguments.begin(), arguments.end());
  arguments.erase(std::unique(arguments.begin(), arguments.end()), arguments.end());
  return arguments;
}

void ClauseMaker::AddLiteral(const Node& node, bool positive) {
  done_.push_back({static_cast<std::uint32_t>(literals_.size())});
  literals_.push_back({positive, Substitute(*node.atom)});
  if (recorder_ != nullptr) recorder_->Literal(positive, *node.atom, literals_.back().atom);
}

Atom ClauseMaker::Substitute(const Atom& atom) {
  work_.Spend(atom.arity() + 1);
  if (atom.is_ground()) return atom;
  std::vector<Term> arguments;
  const auto replace = [this](const Term& term) -> std::optional<Term> {
    if (term.is_variable()) return bindings_[term.variable()];
    if (term.is_ground()) return term;
    return std::nullopt;
  };
  const auto join = [this](Symbol symbol, std::vector<Term> rebuilt) -> std::optional<Term> {
    work_.Spend(rebuilt.size());
    return Term::Compound(symbol, std::move(rebuilt));
  };
  for (const Term& term : atom.arguments()) arguments.push_back(*RebuildTerm(term, replace, join));
  return {atom.predicate(), arguments};
}

void ClauseMaker::Distribute(std::size_t first, std::size_t middle) {
  const std::size_t left = middle - first;
  const std::size_t right = done_.size() - middle;
  if (right == 1) {
    const LiteralIndices last = std::move(done_.back());
    done_.pop_back();
    for (std::size_t i = first; i < middle; ++i) {
      work_.Spend(last.size());
      done_[i].insert(done_[i].end(), last.begin(), last.end());
    }
    return;
  }
  std::vector<LiteralIndices> product;
  for (std::size_t i = 0; i < left * right && !work_.is_spent(); ++i) {
    LiteralIndices& clause = product.emplace_back(done_[first + i / right]);
    const LiteralIndices& other = done_[middle + i % right];
    clause.insert(clause.end(), other.begin(), other.end());
    work_.Spend(clause.size() + 1);
  }
  done_.resize(first);
  std::move(product.begin(), product.end(), std::back_inserter(done_));
}

}  // namespace latchwork::logic

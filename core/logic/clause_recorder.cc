// SPDX-License-Identifier: BSD-3-Clause
#include "core/logic/clause_recorder.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/logic/print.h"

namespace latchwork::logic {

namespace {

using Kind = NormalTree::Kind;

std::vector<Formula> TakeLast(std::vector<Formula>& formulas, std::size_t count) {
  const auto first = formulas.end() - static_cast<std::ptrdiff_t>(count);
  std::vector<Formula> last(std::make_move_iterator(first),
                            std::make_move_iterator(formulas.end()));
  formulas.erase(first, formulas.end());
  return last;
}

Formula Join(bool is_disjunction, std::vector<Formula> children) {
  return is_disjunction ? Formula::Or(std::move(children)) : Formula::And(std::move(children));
}

Formula Signed(bool positive, Atom atom) {
  Formula formula = Formula::Of(std::move(atom));
  return positive ? formula : Formula::Not(std::move(formula));
}

Formula FromNode(const NormalTree::Node& node, std::vector<Formula> children) {
  switch (node.kind) {
    case Kind::kTrue:
      return Formula::True();
    case Kind::kFalse:
      return Formula::False();
    case Kind::kLiteral:
      return Signed(node.positive, *node.atom);
    case Kind::kEquivalent:
      return Formula::Equivalent(std::move(children[0]), std::move(children[1]));
    case Kind::kForall:
      return Formula::Forall(node.variables, std::move(children[0]));
    case Kind::kExists:
      return Formula::Exists(node.variables, std::move(children[0]));
    default:
      return Join(node.kind == Kind::kOr, std::move(children));
  }
}

}  // namespace

void ClauseRecorder::Constant(bool value) {
  normal_.push_back(value ? Formula::True() : Formula::False());
  skolemized_.push_back(normal_.back());
}

void ClauseRecorder::Literal(bool positive, const Atom& atom, const Atom& substituted) {
  normal_.push_back(Signed(positive, atom));
  skolemized_.push_back(Signed(positive, substituted));
}

void ClauseRecorder::Junction(bool is_disjunction, std::size_t count) {
  if (count < 2) return;
  normal_.push_back(Join(is_disjunction, TakeLast(normal_, count)));
  skolemized_.push_back(Join(is_disjunction, TakeLast(skolemized_, count)));
}

void ClauseRecorder::Quantifier(bool is_universal, const std::vector<Variable>& variables,
                                std::vector<Variable> fresh) {
  if (variables.empty()) return;
  Formula& normal = normal_.back();
  normal = is_universal ? Formula::Forall(variables, std::move(normal))
                        : Formula::Exists(variables, std::move(normal));
  if (!is_universal) return;
  skolemized_.back() = Formula::Forall(std::move(fresh), std::move(skolemized_.back()));
}

ClauseOrigins::NormalForm ClauseRecorder::Take(const std::vector<Variable>& sources) {
  ClauseOrigins::NormalForm form;
  form.normal = std::move(normal_.back());
  form.skolemized = std::move(skolemized_.back());
  form.normal_names = DistinctNames(variable_names_);
  for (const Variable source : sources) {
    form.skolemized_names.push_back(source < variable_names_.size() ? variable_names_[source] : "");
  }
  form.skolemized_names = DistinctNames(form.skolemized_names);
  form.skolem_functions = std::move(functions_);
  return form;
}

Formula ToFormula(const NormalTree& tree, NormalTree::Id id) {
  std::vector<NormalTree::Id> order = tree.Below(id);
  std::vector<Formula> values;
  // Backwards, children stand before their node, the first child last.
  std::reverse(order.begin(), order.end());
  for (const NormalTree::Id each : order) {
    const NormalTree::Node& node = tree.nodes[each];
    std::vector<Formula> children = TakeLast(values, node.children.size());
    std::reverse(children.begin(), children.end());
    values.push_back(FromNode(node, std::move(children)));
  }
  return std::move(values.back());
}

}  // namespace latchwork::logic

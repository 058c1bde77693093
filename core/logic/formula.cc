// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/formula.h"

#include <atomic>
#include <cassert>
#include <utility>

namespace latchwork::logic {

struct Formula::Node {
  explicit Node(Kind which) : kind(which) {}

  std::atomic<std::uint32_t> references{1};
  Kind kind;
  Node* next_dead = nullptr;  ///< Once nobody refers to the node.
  Atom atom;
  std::vector<Formula> children;
  std::vector<Variable> variables;
};

Formula::Formula(const Formula& other) : node_(other.node_) {
  if (node_ != nullptr) node_->references.fetch_add(1, std::memory_order_relaxed);
}

Formula::Formula(Formula&& other) noexcept : node_(std::exchange(other.node_, nullptr)) {}

Formula& Formula::operator=(const Formula& other) {
  if (this != &other) *this = Formula(other);
  return *this;
}

Formula& Formula::operator=(Formula&& other) noexcept {
  std::swap(node_, other.node_);
  return *this;
}

Formula::~Formula() {
  if (node_ != nullptr) Release();
}

// Nodes that nobody refers to any more wait in a list of their own, so that depth costs no stack.
void Formula::Release() noexcept {
  Node* dead = nullptr;
  const auto let_go = [&dead](Node* node) {
    if (node == nullptr || node->references.fetch_sub(1, std::memory_order_acq_rel) != 1) return;
    node->next_dead = dead;
    dead = node;
  };
  let_go(std::exchange(node_, nullptr));
  while (dead != nullptr) {
    Node* node = dead;
    dead = node->next_dead;
    for (Formula& child : node->children) let_go(std::exchange(child.node_, nullptr));
    delete node;
  }
}

Formula Formula::True() { return {}; }

Formula Formula::False() { return Formula(new Node(Kind::kFalse)); }

Formula Formula::Of(Atom atom) {
  Formula result(new Node(Kind::kAtom));
  result.node_->atom = std::move(atom);
  return result;
}

Formula Formula::Not(Formula child) {
  Formula result(new Node(Kind::kNot));
  result.node_->children.push_back(std::move(child));
  return result;
}

Formula Formula::And(std::vector<Formula> children) {
  assert(children.size() >= 2);
  Formula result(new Node(Kind::kAnd));
  result.node_->children = std::move(children);
  return result;
}

Formula Formula::Or(std::vector<Formula> children) {
  assert(children.size() >= 2);
  Formula result(new Node(Kind::kOr));
  result.node_->children = std::move(children);
  return result;
}

Formula Formula::Implies(Formula premise, Formula conclusion) {
  Formula result(new Node(Kind::kImplies));
  result.node_->children = {std::move(premise), std::move(conclusion)};
  return result;
}

Formula Formula::Equivalent(Formula a, Formula b) {
  Formula result(new Node(Kind::kEquivalent));
  result.node_->children = {std::move(a), std::move(b)};
  return result;
}

Formula Formula::With(std::vector<Formula> children) const {
  if (children.empty()) return *this;
  Formula result(new Node(kind()));
  const auto bound = variables();
  result.node_->variables.assign(bound.begin(), bound.end());
  result.node_->children = std::move(children);
  return result;
}

Formula Formula::Forall(std::vector<Variable> variables, Formula child) {
  Formula result(new Node(Kind::kForall));
  result.node_->variables = std::move(variables);
  result.node_->children.push_back(std::move(child));
  return result;
}

Formula Formula::Exists(std::vector<Variable> variables, Formula child) {
  Formula result(new Node(Kind::kExists));
  result.node_->variables = std::move(variables);
  result.node_->children.push_back(std::move(child));
  return result;
}

Formula::Kind Formula::kind() const { return node_ == nullptr ? Kind::kTrue : node_->kind; }

const Atom& Formula::atom() const {
  assert(kind() == Kind::kAtom);
  return node_->atom;
}

std::span<const Formula> Formula::children() const {
  if (node_ == nullptr) return {};
  return node_->children;
}

std::span<const Variable> Formula::variables() const {
  if (node_ == nullptr) return {};
  return node_->variables;
}

}  // namespace latchwork::logic

// SPDX-License-Identifier: BSD-3-Clause
#include "core/logic/miniscope.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace latchwork::logic {

namespace {

using Kind = NormalTree::Kind;
using Id = NormalTree::Id;
using Node = NormalTree::Node;

constexpr std::size_t kMostFreeVariables = 4'000'000;
constexpr std::size_t kMostSteps = 50'000'000;

bool IsQuantifier(Kind kind) { return kind == Kind::kForall || kind == Kind::kExists; }

std::vector<Variable> FreeOf(const Node& node, const FreeVariableTable& table) {
  std::vector<Variable> free;
  if (node.kind == Kind::kLiteral) CollectVariables(*node.atom, free);
  for (const Id child : node.children) {
    free.insert(free.end(), table[child].begin(), table[child].end());
  }
  SortUnique(free);
  for (const Variable variable : node.variables) {
    const auto found = std::lower_bound(free.begin(), free.end(), variable);
    if (found != free.end() && *found == variable) free.erase(found);
  }
  return free;
}

std::optional<FreeVariableTable> MakeTable(const NormalTree& tree) {
  FreeVariableTable table(tree.nodes.size());
  std::vector<Id> order = tree.Below(tree.root);
  std::reverse(order.begin(), order.end());
  std::size_t total = 0;
  for (const Id id : order) {
    table[id] = FreeOf(tree.nodes[id], table);
    total += table[id].size();
    if (total > kMostFreeVariables) return std::nullopt;
  }
  return table;
}

class Miniscoper {
 public:
  Miniscoper(NormalTree& tree, FreeVariableTable& free) : tree_(tree), free_(free) {}

  void Run() {
    std::vector<Id> order = tree_.Below(tree_.root);
    std::reverse(order.begin(), order.end());
    for (const Id id : order) {
      if (IsQuantifier(tree_.nodes[id].kind)) Release(id);
    }
  }

 private:
  bool IsFree(Variable variable, Id id) const {
    return std::binary_search(free_[id].begin(), free_[id].end(), variable);
  }

  /// Takes the quantifier off its formula and sets each of its variables down where it belongs.
  void Release(Id id) {
    Node node = std::move(tree_.nodes[id]);
    const Id child = node.children[0];
    tree_.nodes[id] = std::move(tree_.nodes[child]);
    free_[id] = std::move(free_[child]);
    for (const Variable each : node.variables) Push(node.kind, each, id);
  }

  void Push(Kind quantifier, Variable variable, Id id) {
    while (IsFree(variable, id)) {
      const auto next = steps_ < kMostSteps ? Inward(quantifier, variable, id) : std::nullopt;
      if (!next) return Wrap(quantifier, variable, id);
      const auto found = std::lower_bound(free_[id].begin(), free_[id].end(), variable);
      free_[id].erase(found);
      id = *next;
    }
  }

  /// The child that a quantifier at `id` can move to; nothing when it must stay.
  std::optional<Id> Inward(Kind quantifier, Variable variable, Id id) {
    Node& node = tree_.nodes[id];
    steps_ += node.children.size() + 1;
    if (node.kind == quantifier) return node.children[0];
    if (node.kind != Kind::kAnd && node.kind != Kind::kOr) return std::nullopt;
    const auto has_variable = [&](Id child) { return IsFree(variable, child); };
    const auto first = std::find_if(node.children.begin(), node.children.end(), has_variable);
    if (std::any_of(first + 1, node.children.end(), has_variable)) return std::nullopt;
    return *first;
  }

  void Wrap(Kind quantifier, Variable variable, Id id) {
    const Id inner = tree_.Add(std::move(tree_.nodes[id]));
    tree_.nodes[id] = {.kind = quantifier, .children = {inner}, .variables = {variable}};
    free_.push_back(std::move(free_[id]));
    free_[id] = FreeOf(tree_.nodes[id], free_);
  }

  NormalTree& tree_;
  FreeVariableTable& free_;
  std::size_t steps_ = 0;
};

}  // namespace

std::optional<FreeVariableTable> Miniscope(NormalTree& tree) {
  auto table = MakeTable(tree);
  if (table) Miniscoper(tree, *table).Run();
  return table;
}

}  // namespace latchwork::logic

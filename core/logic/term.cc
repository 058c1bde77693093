// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/term.h"

#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <new>

namespace latchwork::logic {

/// One allocation holds the node and, behind it, its arguments.
struct Term::Node {
  Node(Symbol symbol, std::size_t size) : function(symbol), count(size) {}

  Term* arguments() { return reinterpret_cast<Term*>(this + 1); }

  std::atomic<std::uint32_t> references{1};
  bool ground = true;
  Symbol function;
  std::size_t count;
  Node* next_dead = nullptr;  ///< Once nobody refers to the node.
};

namespace {

std::strong_ordering CompareReals(double a, double b) {
  return std::strong_order(a == 0.0 ? 0.0 : a, b == 0.0 ? 0.0 : b);
}

}  // namespace

Term Term::Var(Variable variable) {
  Term term;
  term.kind_ = Kind::kVariable;
  term.value_.variable = variable;
  return term;
}

Term Term::Integer(std::int64_t value) {
  Term term;
  term.kind_ = Kind::kInteger;
  term.value_.integer = value;
  return term;
}

Term Term::Real(double value) {
  Term term;
  term.kind_ = Kind::kReal;
  term.value_.real = value;
  return term;
}

Term Term::Constant(Symbol symbol) {
  Term term;
  term.value_.constant = symbol;
  return term;
}

Term Term::Compound(Symbol function, std::vector<Term> arguments) {
  assert(!arguments.empty());
  static_assert(alignof(Term) <= alignof(Node) && sizeof(Node) % alignof(Term) == 0);
  void* memory = ::operator new(sizeof(Node) + arguments.size() * sizeof(Term));
  Node* node = new (memory) Node(function, arguments.size());
  std::uninitialized_move(arguments.begin(), arguments.end(), node->arguments());
  for (const Term& argument : std::span<const Term>(node->arguments(), node->count)) {
    node->ground = node->ground && argument.is_ground();
  }
  Term term;
  term.kind_ = Kind::kCompound;
  term.value_.node = node;
  return term;
}

void Term::Retain() const noexcept {
  value_.node->references.fetch_add(1, std::memory_order_relaxed);
}

// Nodes that nobody refers to any more wait in a list of their own, so that depth costs no stack.
void Term::Release() const noexcept {
  Node* dead = nullptr;
  const auto let_go = [&dead](Node* node) {
    if (node->references.fetch_sub(1, std::memory_order_acq_rel) != 1) return;
    node->next_dead = dead;
    dead = node;
  };
  let_go(value_.node);
  while (dead != nullptr) {
    Node* node = dead;
    dead = node->next_dead;
    for (const Term& argument : std::span<const Term>(node->arguments(), node->count)) {
      if (argument.kind_ == Kind::kCompound) let_go(argument.value_.node);
    }
    // The arguments need no destructor call: compound ones were let go above.
    node->~Node();
    ::operator delete(node);
  }
}

bool Term::is_ground() const {
  if (kind_ == Kind::kCompound) return value_.node->ground;
  return kind_ != Kind::kVariable;
}

Symbol Term::symbol() const {
  assert(kind_ == Kind::kConstant || kind_ == Kind::kCompound);
  return kind_ == Kind::kCompound ? value_.node->function : value_.constant;
}

std::span<const Term> Term::arguments() const {
  if (kind_ != Kind::kCompound) return {};
  return {value_.node->arguments(), value_.node->count};
}

// Compound terms are told apart by function and arity alone.
std::strong_ordering Term::CompareHeads(const Term& a, const Term& b) {
  if (a.kind_ != b.kind_) return a.kind_ <=> b.kind_;
  switch (a.kind_) {
    case Kind::kVariable:
      return a.value_.variable <=> b.value_.variable;
    case Kind::kInteger:
      return a.value_.integer <=> b.value_.integer;
    case Kind::kReal:
      return CompareReals(a.value_.real, b.value_.real);
    case Kind::kConstant:
      return a.value_.constant <=> b.value_.constant;
    case Kind::kCompound:
      break;
  }
  if (a.value_.node == b.value_.node) return std::strong_ordering::equal;
  const auto by_function = a.value_.node->function <=> b.value_.node->function;
  return std::is_neq(by_function) ? by_function : a.value_.node->count <=> b.value_.node->count;
}

// Heads of all arguments first, then what is inside them: still a total order, and flat terms need
// no memory.
std::strong_ordering operator<=>(const Term& a, const Term& b) {
  if (const auto heads = Term::CompareHeads(a, b); std::is_neq(heads)) return heads;
  if (a.kind_ != Term::Kind::kCompound || a.value_.node == b.value_.node) {
    return std::strong_ordering::equal;
  }
  std::vector<std::pair<Term::Node*, Term::Node*>> pending;
  std::pair<Term::Node*, Term::Node*> pair(a.value_.node, b.value_.node);
  while (true) {
    for (std::size_t i = 0; i < pair.first->count; ++i) {
      const Term& x = pair.first->arguments()[i];
      const Term& y = pair.second->arguments()[i];
      if (const auto heads = Term::CompareHeads(x, y); std::is_neq(heads)) return heads;
      if (x.kind_ == Term::Kind::kCompound && x.value_.node != y.value_.node) {
        pending.emplace_back(x.value_.node, y.value_.node);
      }
    }
    if (pending.empty()) return std::strong_ordering::equal;
    pair = pending.back();
    pending.pop_back();
  }
}

bool operator==(const Term& a, const Term& b) { return std::is_eq(a <=> b); }

}  // namespace latchwork::logic

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/terms.h"

#include <algorithm>

namespace latchwork::pttp::saturation {
namespace {

constexpr std::uint32_t kHeaviest = 1U << 30U;
constexpr std::size_t kFirstBuckets = 1024;

std::uint32_t Add(std::uint32_t a, std::uint32_t b) { return std::min(a + b, kHeaviest); }

}  // namespace

Terms::Terms() : buckets_(kFirstBuckets, kNoTerm) {
  AddFunctor({});
  Make(0, {});
}

FunctorId Terms::AddFunctor(const Functor& functor) {
  functors_.push_back(functor);
  return static_cast<FunctorId>(functors_.size() - 1);
}

std::size_t Terms::Bucket(FunctorId functor, std::span<const TermId> arguments) const {
  std::uint64_t hash = functor * 0x9E3779B97F4A7C15ULL;
  for (const TermId argument : arguments) {
    hash = (hash ^ argument) * 0xD6E8FEB86659FD93ULL;
    hash ^= hash >> 32U;
  }
  return (hash ^ (hash >> 29U)) & (buckets_.size() - 1);
}

void Terms::Weigh(Node& node) const {
  const Functor& functor = functors_[node.functor];
  node.weight = functor.weight;
  node.size = 2;
  node.goal_weight = functor.goal_weight;
  for (std::uint32_t i = 0; i < functor.arity; ++i) {
    const TermId argument = arguments_[node.arguments + i];
    node.weight = Add(node.weight, weight(argument));
    node.size = Add(node.size, size(argument));
    node.goal_weight = Add(node.goal_weight, goal_weight(argument));
  }
}

TermId Terms::Make(FunctorId functor, std::span<const TermId> arguments) {
  std::size_t bucket = Bucket(functor, arguments);
  for (TermId id = buckets_[bucket]; id != kNoTerm; id = nodes_[id].next) {
    if (nodes_[id].functor == functor && std::ranges::equal(this->arguments(id), arguments)) {
      return id;
    }
  }
  if (nodes_.size() >= buckets_.size()) {
    Grow();
    bucket = Bucket(functor, arguments);
  }
  Node node{};
  node.functor = functor;
  node.arguments = static_cast<std::uint32_t>(arguments_.size());
  node.next = buckets_[bucket];
  node.ground = std::ranges::all_of(arguments, [&](TermId a) { return is_ground(a); });
  arguments_.insert(arguments_.end(), arguments.begin(), arguments.end());
  Weigh(node);
  nodes_.push_back(node);
  buckets_[bucket] = static_cast<TermId>(nodes_.size() - 1);
  return buckets_[bucket];
}

// Newest first in every chain: so Rollback takes off heads only.
void Terms::Grow() {
  buckets_.assign(buckets_.size() * 2, kNoTerm);
  for (std::size_t id = 0; id < nodes_.size(); ++id) {
    const auto term = static_cast<TermId>(id);
    TermId& head = buckets_[Bucket(nodes_[id].functor, arguments(term))];
    nodes_[id].next = head;
    head = term;
  }
}

void Terms::Rollback(std::size_t mark) {
  while (nodes_.size() > mark) {
    const auto term = static_cast<TermId>(nodes_.size() - 1);
    const Node& node = nodes_.back();
    buckets_[Bucket(node.functor, arguments(term))] = node.next;
    arguments_.resize(node.arguments);
    nodes_.pop_back();
  }
}

void Terms::Reweigh() {
  for (Node& node : nodes_) Weigh(node);
}

std::size_t Terms::bytes() const {
  return nodes_.capacity() * sizeof(Node) +
         (arguments_.capacity() + buckets_.capacity()) * sizeof(TermId);
}

}  // namespace latchwork::pttp::saturation

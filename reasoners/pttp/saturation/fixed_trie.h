// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_FIXED_TRIE_H_
#define LATCHWORK_PTTP_SATURATION_FIXED_TRIE_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace latchwork::pttp::saturation {

/// Entries under keys of `Depth` numbers, found again by asking on each level which numbers will
/// do. Entries come out in an order that depends on the insertions alone.
template <class Entry, std::size_t Depth>
class FixedTrie {
 public:
  using Key = std::array<std::int32_t, Depth>;

  FixedTrie() : nodes_(1) {}

  void Insert(const Key& key, const Entry& entry) {
    std::uint32_t node = 0;
    for (const std::int32_t part : key) {
      const auto at = Find(node, part);
      if (at != nodes_[node].children.end() && at->part == part) {
        node = at->node;
        continue;
      }
      const auto child = static_cast<std::uint32_t>(nodes_.size());
      nodes_[node].children.insert(at, {part, child});
      nodes_.emplace_back();
      node = child;
    }
    nodes_[node].entries.push_back(entry);
    ++size_;
  }

  /// Removes the entries under `key` that the predicate names.
  template <class Which>
  void Erase(const Key& key, const Which& which) {
    std::uint32_t node = 0;
    for (const std::int32_t part : key) {
      const auto at = Find(node, part);
      if (at == nodes_[node].children.end() || at->part != part) return;
      node = at->node;
    }
    size_ -= std::erase_if(nodes_[node].entries, which);
  }

  /// Calls `visit(entry)` for the entries whose key passes `accept(level, part)` on every level,
  /// until it returns true; says whether it did.
  template <class Accept, class Visit>
  bool Search(const Accept& accept, const Visit& visit) const {
    return SearchFrom(0, 0, accept, visit);
  }

  std::size_t bytes() const {
    return nodes_.size() * (sizeof(Node) + 2 * sizeof(Child)) + size_ * 2 * sizeof(Entry);
  }

 private:
  struct Child {
    std::int32_t part;
    std::uint32_t node;
  };
  struct Node {
    std::vector<Child> children;
    std::vector<Entry> entries;
  };

  auto Find(std::uint32_t node, std::int32_t part) {
    return std::lower_bound(nodes_[node].children.begin(), nodes_[node].children.end(), part,
                            [](const Child& child, std::int32_t p) { return child.part < p; });
  }

  template <class Accept, class Visit>
  bool SearchFrom(std::uint32_t node, std::size_t level, const Accept& accept,
                  const Visit& visit) const {
    if (level == Depth) {
      return std::any_of(nodes_[node].entries.begin(), nodes_[node].entries.end(), visit);
    }
    const std::vector<Child>& children = nodes_[node].children;
    return std::any_of(children.begin(), children.end(), [&](const Child& child) {
      return accept(level, child.part) && SearchFrom(child.node, level + 1, accept, visit);
    });
  }

  std::vector<Node> nodes_;
  std::size_t size_ = 0;
};

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_FIXED_TRIE_H_

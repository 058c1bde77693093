// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_STACK_H_
#define LATCHWORK_ICARUS_STACK_H_

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace latchwork::icarus {

/// A stack that keeps its memory and leaves items as they are: what Push gives holds whatever was
/// there before. References are good until the next Push or Reserve.
template <typename Item>
class Stack {
  static_assert(std::is_trivially_copyable_v<Item>);

 public:
  Item& Push() {
    if (size_ == items_.size()) Grow(size_ + 1);
    return items_[size_++];
  }
  void Push(const Item& item) { Push() = item; }
  /// Makes `count` items more; gives the number of the first.
  std::size_t Reserve(std::size_t count) {
    const std::size_t first = size_;
    size_ += count;
    if (size_ > items_.size()) Grow(size_);
    return first;
  }
  void Pop() { --size_; }
  void Shrink(std::size_t size) { size_ = size; }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Item& back() { return items_[size_ - 1]; }
  Item* data() { return items_.data(); }
  const Item* data() const { return items_.data(); }
  Item& operator[](std::size_t index) { return items_[index]; }
  const Item& operator[](std::size_t index) const { return items_[index]; }

 private:
  [[gnu::noinline]] void Grow(std::size_t size) {
    items_.resize(std::max<std::size_t>(2 * size, 64));
  }

  std::vector<Item> items_;
  std::size_t size_ = 0;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_STACK_H_

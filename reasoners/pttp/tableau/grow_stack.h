// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_GROW_STACK_H_
#define LATCHWORK_PTTP_TABLEAU_GROW_STACK_H_

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace latchwork::pttp {

/// A stack of plain values that never gives memory back, so that pushing and truncating in the
/// search cost a comparison and a store. Elements move when it grows.
template <typename Value>
class GrowStack {
 public:
  static_assert(std::is_trivially_copyable_v<Value>);

  /// So many values past the last one may be written to.
  static constexpr std::size_t kSlack = 4;

  GrowStack() : storage_(kFirst + kSlack), data_(storage_.data()), capacity_(kFirst) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  std::size_t bytes() const { return capacity_ * sizeof(Value); }
  Value& operator[](std::size_t index) { return data_[index]; }
  const Value& operator[](std::size_t index) const { return data_[index]; }
  Value& back() { return data_[size_ - 1]; }

  void Push(const Value& value) {
    if (size_ == capacity_) Grow(1);
    data_[size_++] = value;
  }
  Value Pop() { return data_[--size_]; }
  void Truncate(std::size_t size) { size_ = size; }
  /// The next one, to be written before it is pushed by Extend(1).
  Value& Next() { return data_[size_]; }
  /// So that as many may be added without moving any.
  void Reserve(std::size_t count) {
    if (size_ + count > capacity_) Grow(count);
  }
  const Value* data() const { return data_; }
  Value* data() { return data_; }
  /// Room for `count` more, their values left as they are.
  Value* Extend(std::size_t count) {
    if (size_ + count > capacity_) Grow(count);
    Value* first = data_ + size_;
    size_ += count;
    return first;
  }

 private:
  static constexpr std::size_t kFirst = 1024;

  void Grow(std::size_t count) {
    capacity_ = std::max(2 * capacity_, size_ + count);
    storage_.resize(capacity_ + kSlack);
    data_ = storage_.data();
  }

  std::vector<Value> storage_;
  Value* data_;
  std::size_t size_ = 0;
  std::size_t capacity_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_GROW_STACK_H_

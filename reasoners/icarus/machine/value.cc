// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/value.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <type_traits>

namespace latchwork::icarus {

namespace {

static_assert(sizeof(Value) == 16 && sizeof(ListValue) % alignof(Value) == 0);
static_assert(std::is_trivially_destructible_v<Value>);

template <typename Number>
void AppendNumber(std::string& text, Number number) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  const std::string_view digits(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  text += digits;
  if constexpr (std::is_floating_point_v<Number>) {
    if (digits.find_first_of(".en") == std::string_view::npos) text += ".0";
  }
}

void Append(std::string& text, const Value& value, const NamePool& names) {
  switch (value.kind) {
    case ValueKind::kNone:
      text += '?';
      break;
    case ValueKind::kInteger:
      AppendNumber(text, value.integer);
      break;
    case ValueKind::kReal:
      AppendNumber(text, value.real);
      break;
    case ValueKind::kSymbol:
      text += names.Name(value.name);
      break;
    case ValueKind::kString:
      text += Quoted(names.Name(value.name));
      break;
    case ValueKind::kList:
      text += '(';
      for (const Value& item : value.list->items()) {
        if (text.back() != '(') text += ' ';
        Append(text, item, names);
      }
      text += ')';
  }
}

}  // namespace

NameId NamePool::Intern(std::string_view name) {
  const auto known = ids_.find(name);
  if (known != ids_.end()) return known->second;
  const auto id = static_cast<NameId>(names_.size());
  names_.emplace_back(ids_.emplace(std::string(name), id).first->first);
  return id;
}

Value Value::Integer(std::int64_t value) {
  Value made;
  made.kind = ValueKind::kInteger;
  made.integer = value;
  return made;
}

Value Value::Real(double value) {
  Value made;
  made.kind = ValueKind::kReal;
  made.real = value == 0 ? 0.0 : value;
  return made;
}

Value Value::Symbol(NameId name) {
  Value made;
  made.kind = ValueKind::kSymbol;
  made.name = name;
  return made;
}

Value Value::String(NameId name) {
  Value made = Symbol(name);
  made.kind = ValueKind::kString;
  return made;
}

bool EqualLists(const ListValue& a, const ListValue& b) {
  if (a.hash != b.hash || a.nodes != b.nodes || a.size != b.size) return false;
  const auto left = a.items();
  const auto right = b.items();
  return std::equal(left.begin(), left.end(), right.begin(), Equal);
}

bool IsGround(const Value& value) {
  if (value.kind != ValueKind::kList) return !value.is_none();
  const auto items = value.list->items();
  return std::all_of(items.begin(), items.end(), IsGround);
}

bool Fits(const Value& pattern, const Value& value) {
  if (pattern.is_none()) return true;
  if (pattern.kind != ValueKind::kList || value.kind != ValueKind::kList) {
    return Equal(pattern, value);
  }
  const auto left = pattern.list->items();
  const auto right = value.list->items();
  return std::equal(left.begin(), left.end(), right.begin(), right.end(), Fits);
}

std::string Quoted(std::string_view string) {
  std::string text = "\"";
  for (const char c : string) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}

std::string ToString(const Value& value, const NamePool& names) {
  std::string text;
  Append(text, value, names);
  return text;
}

Arena& Arena::operator=(Arena&& other) noexcept {
  block_bytes_ = other.block_bytes_;
  blocks_ = std::exchange(other.blocks_, {});
  used_blocks_ = std::exchange(other.used_blocks_, 0);
  next_ = std::exchange(other.next_, nullptr);
  left_ = std::exchange(other.left_, 0);
  return *this;
}

/// The blocks that are passed over are too small.
void* Arena::AllocateInNextBlock(std::size_t bytes) {
  while (used_blocks_ < blocks_.size() && blocks_[used_blocks_].size() < bytes) ++used_blocks_;
  if (used_blocks_ == blocks_.size()) {
    const std::size_t grown = blocks_.empty() ? kFirstBlock : 2 * blocks_.back().size();
    blocks_.emplace_back(std::max(bytes, std::min(grown, block_bytes_)));
  }
  UseBlock();
  left_ -= bytes;
  return std::exchange(next_, next_ + bytes);
}

Value Arena::MakeList(std::span<const Value> items) {
  std::uint32_t nodes = 1;
  std::uint32_t depth = 0;
  std::uint64_t hash = MixHash(static_cast<std::uint64_t>(ValueKind::kList), items.size());
  for (const Value& item : items) {
    const bool list = item.kind == ValueKind::kList;
    nodes += list ? item.list->nodes : 1;
    depth = std::max(depth, list ? item.list->depth : 0);
    hash = MixHash(hash, Hash(item));
    if (nodes > kMaxListNodes || depth >= kMaxListDepth) return {};
  }
  void* const memory = Allocate(sizeof(ListValue) + items.size() * sizeof(Value));
  auto* const list =
      ::new (memory) ListValue{static_cast<std::uint32_t>(items.size()), nodes, depth + 1, hash};
  auto* const copy = reinterpret_cast<Value*>(list + 1);
  for (std::size_t i = 0; i < items.size(); ++i) ::new (copy + i) Value(items[i]);
  Value made;
  made.kind = ValueKind::kList;
  made.list = list;
  return made;
}

Value Arena::Copy(const Value& value) {
  if (value.kind != ValueKind::kList) return value;
  Value copy = MakeList(value.list->items());
  auto* const items = reinterpret_cast<Value*>(const_cast<ListValue*>(copy.list) + 1);
  for (std::uint32_t i = 0; i < copy.list->size; ++i) items[i] = Copy(items[i]);
  return copy;
}

}  // namespace latchwork::icarus

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_VALUE_H_
#define LATCHWORK_ICARUS_VALUE_H_

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace latchwork::icarus {

using NameId = std::uint32_t;
inline constexpr NameId kNoName = std::numeric_limits<NameId>::max();

/// The symbols and strings of one interpreter, numbered as they are met.
class NamePool {
 public:
  /// `name` as it is compared: symbols folded.
  NameId Intern(std::string_view name);
  std::string_view Name(NameId id) const { return names_[id]; }

 private:
  std::map<std::string, NameId, std::less<>> ids_;
  std::vector<std::string_view> names_;
};

enum class ValueKind : std::uint8_t { kNone, kInteger, kReal, kSymbol, kString, kList };

struct ListValue;

/// A ground value, or none: an unbound variable, or the False of a function. Lists are shared, and
/// live as long as the memory that they were made in.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): the members of a union are not all set
struct Value {
  ValueKind kind = ValueKind::kNone;
  NameId name = kNoName;  ///< kSymbol, kString.
  union {
    std::int64_t integer = 0;
    double real;
    const ListValue* list;
  };

  static Value Integer(std::int64_t value);
  static Value Real(double value);
  static Value Symbol(NameId name);
  static Value String(NameId name);

  bool is_none() const { return kind == ValueKind::kNone; }
  bool is_number() const { return kind == ValueKind::kInteger || kind == ValueKind::kReal; }
  double number() const {
    return kind == ValueKind::kInteger ? static_cast<double>(integer) : real;
  }
  /// The member of the union that is set, whichever it is.
  std::uint64_t bits() const {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &integer, sizeof bits);
    return bits;
  }
};

/// Its items follow it in memory.
struct ListValue {
  std::uint32_t size;
  std::uint32_t nodes;  ///< Values in it, however deep, and itself.
  std::uint32_t depth;
  std::uint64_t hash;

  std::span<const Value> items() const { return {reinterpret_cast<const Value*>(this + 1), size}; }
};

/// Lists beyond these bounds are not made.
inline constexpr std::uint32_t kMaxListDepth = 1000;
inline constexpr std::uint32_t kMaxListNodes = 1U << 16U;

/// Of two lists.
bool EqualLists(const ListValue& a, const ListValue& b);
/// As `equal` of Common Lisp: 1 and 1.0 differ.
inline bool Equal(const Value& a, const Value& b) {
  if (a.kind != b.kind || a.name != b.name) return false;
  return a.bits() == b.bits() || (a.kind == ValueKind::kList && EqualLists(*a.list, *b.list));
}

/// Whether nothing in it is none.
bool IsGround(const Value& value);
/// Whether a value is what a pattern says: none, also within lists, stands for anything.
bool Fits(const Value& pattern, const Value& value);

inline std::uint64_t MixHash(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9e3779b97f4a7c15ULL;
  return hash ^ (hash >> 29U);
}
inline std::uint64_t Hash(const Value& value) {
  if (value.kind == ValueKind::kList) return value.list->hash;
  return MixHash(static_cast<std::uint64_t>(value.kind), value.bits() ^ value.name);
}
/// In double quotes.
std::string Quoted(std::string_view string);
/// As the reader would read it back.
std::string ToString(const Value& value, const NamePool& names);

/// Memory that is given back all at once and then used again.
class Arena {
 public:
  /// Takes its memory from the system in blocks, each twice as large as the one before, up to this
  /// size: what lives for a cycle or two does not pay for what runs for hours.
  explicit Arena(std::size_t block_bytes = 1U << 16U) : block_bytes_(block_bytes) {}
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;
  Arena(Arena&& other) noexcept { *this = std::move(other); }
  Arena& operator=(Arena&& other) noexcept;
  ~Arena() = default;

  void* Allocate(std::size_t bytes) {
    bytes = (bytes + alignof(Value) - 1) / alignof(Value) * alignof(Value);
    if (bytes > left_) return AllocateInNextBlock(bytes);
    left_ -= bytes;
    return std::exchange(next_, next_ + bytes);
  }
  void Reset() {
    used_blocks_ = left_ = 0;
    if (!blocks_.empty()) UseBlock();
  }
  /// A list of these values, which it shares; none when it would be too deep or too large.
  Value MakeList(std::span<const Value> items);
  /// The value with all its lists in this arena.
  Value Copy(const Value& value);
  std::span<Value> MakeValues(std::size_t count) {
    auto* const values = static_cast<Value*>(Allocate(count * sizeof(Value)));
    for (std::size_t i = 0; i < count; ++i) ::new (values + i) Value();
    return {values, count};
  }
  /// The same values, their lists where they are.
  std::span<Value> CopyValues(std::span<const Value> values) {
    auto* const copy = static_cast<Value*>(Allocate(values.size_bytes()));
    for (std::size_t i = 0; i < values.size(); ++i) ::new (copy + i) Value(values[i]);
    return {copy, values.size()};
  }

 private:
  [[gnu::noinline]] void* AllocateInNextBlock(std::size_t bytes);
  void UseBlock() {
    next_ = blocks_[used_blocks_].data();
    left_ = blocks_[used_blocks_++].size();
  }

  static constexpr std::size_t kFirstBlock = 1U << 10U;

  std::size_t block_bytes_ = 0;
  std::vector<std::vector<std::byte>> blocks_;
  std::size_t used_blocks_ = 0;
  std::byte* next_ = nullptr;  ///< In the last block that is used.
  std::size_t left_ = 0;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_VALUE_H_

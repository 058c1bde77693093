// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_VALUE_H_
#define LATCHWORK_ICARUS_VALUE_H_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
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

/// As `equal` of Common Lisp: 1 and 1.0 differ.
bool Equal(const Value& a, const Value& b);
std::uint64_t Hash(const Value& value);
/// As the reader would read it back.
std::string ToString(const Value& value, const NamePool& names);

/// Memory that is given back all at once and then used again.
class Arena {
 public:
  /// Takes its memory from the system in blocks of this size.
  explicit Arena(std::size_t block_bytes = 1U << 16U) : block_bytes_(block_bytes) {}

  void* Allocate(std::size_t bytes);
  void Reset();
  /// A list of these values, which it shares; none when it would be too deep or too large.
  Value MakeList(std::span<const Value> items);
  /// The value with all its lists in this arena.
  Value Copy(const Value& value);
  std::span<Value> MakeValues(std::size_t count);

 private:
  std::size_t block_bytes_;
  std::vector<std::vector<std::byte>> blocks_;
  std::size_t block_ = 0;
  std::size_t used_ = 0;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_VALUE_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_VALUES_VALUE_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_VALUES_VALUE_H_

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "latchwork/logic/symbol.h"
#include "latchwork/logic/term.h"

namespace latchwork::circumscription {

/// A ground term in two words, equal to another one exactly when the terms are. Compound terms are
/// numbers of a ValueBank.
struct Value {
  enum class Kind : std::uint8_t { kInteger, kReal, kConstant, kCompound };
  std::uint64_t bits = 0;
  Kind kind = Kind::kInteger;

  bool is_number() const { return kind == Kind::kInteger || kind == Kind::kReal; }
  friend bool operator==(const Value&, const Value&) = default;
};

inline std::uint64_t Mix(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9E3779B97F4A7C15U;
  return hash ^ (hash >> 29U);
}
inline std::uint64_t Mix(std::uint64_t hash, const Value& value) {
  return Mix(hash + static_cast<std::uint64_t>(value.kind), value.bits);
}
std::uint64_t HashOf(std::span<const Value> values);

/// Row numbers, found by the hash of what they stand for. Knows nothing of the rows: the caller
/// compares.
class RowTable {
 public:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  void Clear();
  /// The first row of that hash for which `same(row)` holds, else kNone.
  template <typename Same>
  std::uint32_t Find(std::uint64_t hash, const Same& same) const {
    if (slots_.empty()) return kNone;
    for (std::size_t i = hash & mask(); slots_[i].row != kNone; i = (i + 1) & mask()) {
      if (slots_[i].hash == hash && same(slots_[i].row)) return slots_[i].row;
    }
    return kNone;
  }
  void Insert(std::uint64_t hash, std::uint32_t row);

 private:
  struct Slot {
    std::uint64_t hash = 0;
    std::uint32_t row = kNone;
  };
  std::size_t mask() const { return slots_.size() - 1; }
  void Put(const Slot& slot);

  std::vector<Slot> slots_;
  std::size_t used_ = 0;
};

/// Makes values of terms and terms of values. Numbers and constants need no memory; each compound
/// term is kept once, with its term, until Clear. Not thread-safe.
class ValueBank {
 public:
  /// `term` is ground.
  Value Of(const logic::Term& term);
  static Value OfReal(double real);
  static Value OfConstant(logic::Symbol symbol) {
    return {std::bit_cast<std::uint64_t>(symbol), Value::Kind::kConstant};
  }
  /// `arguments` may be the arguments of another value.
  Value Compound(logic::Symbol function, std::span<const Value> arguments);

  logic::Term ToTerm(const Value& value) const;
  /// Of compound values only.
  logic::Symbol Function(const Value& compound) const { return compounds_[compound.bits].function; }
  /// Valid until the next compound is made.
  std::span<const Value> Arguments(const Value& compound) const;

  std::size_t size() const { return compounds_.size(); }
  /// All compound values are void after it.
  void Clear();

 private:
  struct Record {
    logic::Symbol function;
    std::size_t first = 0;
    std::size_t count = 0;
    logic::Term term;
  };

  std::vector<Record> compounds_;
  std::vector<Value> arguments_;
  std::vector<Value> scratch_;
  RowTable table_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_VALUES_VALUE_H_

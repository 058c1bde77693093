// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_TERM_H_
#define LATCHWORK_LOGIC_TERM_H_

#include <cassert>
#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/logic/symbol.h"

namespace latchwork::logic {

class Term;

/// Variables of a clause or formula are numbered; their names, where anyone gave one, are kept
/// beside it.
using Variable = std::uint32_t;

/// A first-order term as an immutable value: a variable, an integer, a real, a constant, or a
/// function applied to arguments. Numbers and constants need no heap memory; compound terms share
/// their nodes (counted, thread-safe). Nesting may be deep: copying, destroying, comparing and
/// printing do not recurse.
class Term {
 public:
  enum class Kind : std::uint8_t { kVariable, kInteger, kReal, kConstant, kCompound };

  /// The constant `null symbol`; only there so that containers can be resized.
  Term() = default;
  Term(const Term& other) : kind_(other.kind_), value_(other.value_) {
    if (kind_ == Kind::kCompound) Retain();
  }
  Term(Term&& other) noexcept : kind_(other.kind_), value_(other.value_) {
    other.kind_ = Kind::kConstant;
    other.value_ = Value();
  }
  Term& operator=(const Term& other) {
    if (this != &other) *this = Term(other);
    return *this;
  }
  Term& operator=(Term&& other) noexcept {
    std::swap(kind_, other.kind_);
    std::swap(value_, other.value_);
    return *this;
  }
  ~Term() {
    if (kind_ == Kind::kCompound) Release();
  }

  static Term Var(Variable variable);
  static Term Integer(std::int64_t value);
  static Term Real(double value);
  static Term Constant(Symbol symbol);
  /// `arguments` must not be empty.
  static Term Compound(Symbol function, std::vector<Term> arguments);

  Kind kind() const { return kind_; }
  bool is_variable() const { return kind_ == Kind::kVariable; }
  bool is_number() const { return kind_ == Kind::kInteger || kind_ == Kind::kReal; }
  bool is_ground() const;

  Variable variable() const {
    assert(kind_ == Kind::kVariable);
    return value_.variable;
  }
  std::int64_t integer() const {
    assert(kind_ == Kind::kInteger);
    return value_.integer;
  }
  double real() const {
    assert(kind_ == Kind::kReal);
    return value_.real;
  }
  /// The value of an integer or a real.
  double number() const {
    return kind_ == Kind::kInteger ? static_cast<double>(integer()) : real();
  }
  /// The symbol of a constant or the function symbol of a compound term.
  Symbol symbol() const;
  /// Empty but for compound terms.
  std::span<const Term> arguments() const;

  /// Structural. Reals are equal when their bits are, but for -0.0 == 0.0; 1 and 1.0 are different
  /// terms.
  friend bool operator==(const Term& a, const Term& b);
  /// A total order that does not depend on addresses: variables < integers < reals < constants <
  /// compound terms.
  friend std::strong_ordering operator<=>(const Term& a, const Term& b);

 private:
  struct Node;
  union Value {
    Value() : constant() {}
    Variable variable;
    std::int64_t integer;
    double real;
    Symbol constant;
    Node* node;
  };

  static std::strong_ordering CompareHeads(const Term& a, const Term& b);
  void Retain() const noexcept;
  void Release() const noexcept;

  Kind kind_ = Kind::kConstant;
  Value value_;
};

/// TPTP syntax. Variables print as their name in `variable_names`, else as X<number>; reals always
/// show a '.' or an exponent and read back to the same bits; words are quoted where TPTP asks for
/// it.
std::string ToString(const Term& term, std::span<const std::string> variable_names = {});
/// A bare name as TPTP writes it: quoted and escaped where needed.
std::string QuoteWord(std::string_view name);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_TERM_H_

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/terms/calculator.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "reasoners/pttp/terms/exact_reals.h"

namespace latchwork::pttp {
namespace {

logic::Term ToTerm(const Number& number) {
  return number.tag == Tag::kInteger
             ? logic::Term::Integer(std::bit_cast<std::int64_t>(number.bits))
             : logic::Term::Real(number.real());
}

using Terms = std::array<logic::Term, Calculator::kMostArguments>;

Terms ToTerms(const Number* numbers, std::size_t count) {
  Terms terms;
  for (std::size_t i = 0; i < count; ++i) terms[i] = ToTerm(numbers[i]);
  return terms;
}

using Numbers = std::array<Number, Calculator::kMostArguments>;

/// False when one is not a number.
bool ReadNumbers(const Word* words, std::size_t count, Numbers& numbers) {
  if (count > numbers.size()) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const Word word = Dereference(words[i]);
    if (!IsNumber(word)) return false;
    numbers[i] = Number::In(word);
  }
  return true;
}

/// A function applied to numbers.
bool IsFlat(Word word) {
  if (TagOf(word) != Tag::kCompound) return false;
  const Word* block = AddressOf(word);
  return std::all_of(block + 1, block + 1 + ArityOf(block[0]), IsNumber);
}

bool MayApply(Reals reals, logic::Arithmetic::Function function, const Number* numbers,
              std::size_t arity) {
  switch (reals) {
    case Reals::kExact:
      return IsExact(function, numbers, arity);
    case Reals::kGiven:
      return AllowsRoundedNumerals(function, numbers, arity);
    default:
      return true;
  }
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Not finite for the rarer functions, and where there may be no value.
double Combine(logic::Arithmetic::Function function, double a, double b) {
  using Function = logic::Arithmetic::Function;
  switch (function) {
    case Function::kSum:
      return a + b;
    case Function::kDifference:
      return a - b;
    case Function::kProduct:
      return a * b;
    case Function::kQuotient:
      return b == 0.0 ? kNone : a / b;
    case Function::kMin:
      return std::min(a, b);
    case Function::kMax:
      return std::max(a, b);
    default:
      return kNone;
  }
}

double Change(logic::Arithmetic::Function function, double a) {
  using Function = logic::Arithmetic::Function;
  if (function == Function::kAbs) return std::fabs(a);
  return function == Function::kUminus ? -a : kNone;
}

/// The usual case; false for all others.
bool ApplyToReals(logic::Arithmetic::Function function, const Number* numbers, std::size_t arity,
                  Number& result) {
  if (!numbers[0].IsFiniteReal()) return false;
  double value = kNone;
  if (arity == 1) {
    value = Change(function, numbers[0].real());
  } else if (numbers[1].IsFiniteReal()) {
    value = Combine(function, numbers[0].real(), numbers[1].real());
  }
  if (!std::isfinite(value)) return false;
  result = Number::Real(value == 0.0 ? 0.0 : value);
  return true;
}

}  // namespace

Word Box(const Number& number, Arena& heap) {
  Word* box = heap.Allocate(1);
  *box = number.bits;
  return Tagged(number.tag, box);
}

bool Calculator::Apply(logic::Arithmetic::Function function, const Number* numbers,
                       std::size_t arity, Number& result) {
  if (ApplyToReals(function, numbers, arity, result)) return true;
  const Terms terms = ToTerms(numbers, arity);
  const auto value = logic::Arithmetic::Evaluate(function, std::span(terms.data(), arity));
  if (!value) return false;
  result = value->kind() == logic::Term::Kind::kInteger
               ? Number{Tag::kInteger, std::bit_cast<Word>(value->integer())}
               : Number::Real(value->real());
  return true;
}

std::optional<bool> Calculator::DecideTerms(logic::Arithmetic::Predicate predicate,
                                            const Number* numbers, std::size_t arity) {
  const Terms terms = ToTerms(numbers, arity);
  return logic::Arithmetic::Evaluate(predicate, std::span(terms.data(), arity));
}

std::optional<bool> Calculator::Decide(logic::Arithmetic::Predicate predicate,
                                       const Word* arguments, std::size_t arity) {
  Numbers numbers;
  if (!ReadNumbers(arguments, arity, numbers)) return std::nullopt;
  return Decide(predicate, numbers.data(), arity);
}

std::optional<Word> Calculator::Rebuild(const Word* block, const Word* arguments) {
  const std::size_t arity = ArityOf(block[0]);
  if (const auto function = (*functors_)[NumberOf(block[0])].function) {
    Numbers numbers;
    Number value;
    if (!ReadNumbers(arguments, arity, numbers)) return std::nullopt;
    if (!MayApply(functors_->reals(), *function, numbers.data(), arity)) return std::nullopt;
    if (!Apply(*function, numbers.data(), arity, value)) return std::nullopt;
    return Box(value, *heap_);
  }
  Word* copy = heap_->Allocate(arity + 1);
  copy[0] = block[0];
  std::copy_n(arguments, arity, copy + 1);
  return Tagged(Tag::kCompound, copy);
}

std::optional<Word> Calculator::Normalize(Word word) {
  if (IsFlat(word)) return Rebuild(AddressOf(word), AddressOf(word) + 1);
  values_.clear();
  visits_.assign(1, {word, false});
  while (!visits_.empty()) {
    const Visit visit = visits_.back();
    visits_.pop_back();
    const Word current = Dereference(visit.word);
    if (TagOf(current) != Tag::kCompound) {
      values_.push_back(current);
      continue;
    }
    const Word* block = AddressOf(current);
    const std::size_t arity = ArityOf(block[0]);
    if (!visit.expanded) {
      visits_.push_back({current, true});
      for (std::size_t i = arity; i > 0; --i) visits_.push_back({block[i], false});
      continue;
    }
    const auto value = Rebuild(block, values_.data() + values_.size() - arity);
    if (!value) return std::nullopt;
    values_.resize(values_.size() - arity);
    values_.push_back(*value);
  }
  return values_.back();
}

bool Calculator::Differ(Word a, Word b, bool unique_names) {
  const auto is_distinct_object = [&](Word word) {
    return TagOf(word) == Tag::kConstant &&
           (*functors_)[NumberOf(word)].symbol.kind() == logic::SymbolKind::kDistinctObject;
  };
  pairs_.assign(1, {a, b});
  while (!pairs_.empty()) {
    const Word left = Dereference(pairs_.back().first);
    const Word right = Dereference(pairs_.back().second);
    pairs_.pop_back();
    if (SameAtomic(left, right)) continue;
    if (TagOf(left) == Tag::kReference || TagOf(right) == Tag::kReference) continue;
    if (IsNumber(left) && IsNumber(right)) {
      if (ToTerm(Number::In(left)).number() != ToTerm(Number::In(right)).number()) return true;
      continue;
    }
    const bool left_known = IsNumber(left) || is_distinct_object(left);
    const bool right_known = IsNumber(right) || is_distinct_object(right);
    if (left_known && right_known) return true;
    if (!unique_names) return false;
    if (TagOf(left) != Tag::kCompound || TagOf(right) != Tag::kCompound) return true;
    const Word* first = AddressOf(left);
    const Word* second = AddressOf(right);
    if (first[0] != second[0]) return true;
    for (std::size_t i = ArityOf(first[0]); i > 0; --i) pairs_.emplace_back(first[i], second[i]);
  }
  return false;
}

}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/calculator.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

namespace latchwork::pttp {
namespace {

constexpr std::size_t kMostArguments = 2;
using Numbers = std::array<logic::Term, kMostArguments>;

logic::Term NumberTerm(Word word) {
  const Word bits = *AddressOf(word);
  return TagOf(word) == Tag::kInteger ? logic::Term::Integer(std::bit_cast<std::int64_t>(bits))
                                      : logic::Term::Real(std::bit_cast<double>(bits));
}

/// Nothing when one is not a number.
std::optional<Numbers> ToNumbers(const Word* words, std::size_t count) {
  if (count > kMostArguments) return std::nullopt;
  Numbers numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const Word word = Dereference(words[i]);
    if (!IsNumber(word)) return std::nullopt;
    numbers[i] = NumberTerm(word);
  }
  return numbers;
}

bool IsFiniteReal(Word word) {
  return TagOf(word) == Tag::kReal && std::isfinite(std::bit_cast<double>(*AddressOf(word)));
}

double RealOf(Word word) { return std::bit_cast<double>(*AddressOf(word)); }

/// A function applied to numbers.
bool IsFlat(Word word) {
  if (TagOf(word) != Tag::kCompound) return false;
  const Word* block = AddressOf(word);
  return std::all_of(block + 1, block + 1 + ArityOf(block[0]), IsNumber);
}

/// Nothing for the rarer functions.
std::optional<double> Combine(logic::Arithmetic::Function function, double a, double b) {
  using Function = logic::Arithmetic::Function;
  switch (function) {
    case Function::kSum:
      return a + b;
    case Function::kDifference:
      return a - b;
    case Function::kProduct:
      return a * b;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<bool> Calculator::Decide(logic::Arithmetic::Predicate predicate,
                                       const Word* arguments, std::size_t arity) {
  if (arity == 2 && IsFiniteReal(arguments[0]) && IsFiniteReal(arguments[1])) {
    return logic::Arithmetic::Evaluate(predicate, RealOf(arguments[0]), RealOf(arguments[1]));
  }
  const auto numbers = ToNumbers(arguments, arity);
  if (!numbers) return std::nullopt;
  return logic::Arithmetic::Evaluate(predicate, std::span(numbers->data(), arity));
}

std::optional<Word> Calculator::Apply(const Word* block, const Word* arguments) {
  const std::size_t arity = ArityOf(block[0]);
  if (const auto function = (*functors_)[NumberOf(block[0])].function) {
    if (arity == 2 && IsFiniteReal(arguments[0]) && IsFiniteReal(arguments[1])) {
      const auto value = Combine(*function, RealOf(arguments[0]), RealOf(arguments[1]));
      if (value && std::isfinite(*value)) return RealWord(*value, *heap_);
    }
    const auto numbers = ToNumbers(arguments, arity);
    if (!numbers) return std::nullopt;
    const auto value = logic::Arithmetic::Evaluate(*function, std::span(numbers->data(), arity));
    if (!value) return std::nullopt;
    return value->kind() == logic::Term::Kind::kInteger ? IntegerWord(value->integer(), *heap_)
                                                        : RealWord(value->real(), *heap_);
  }
  Word* copy = heap_->Allocate(arity + 1);
  copy[0] = block[0];
  std::copy_n(arguments, arity, copy + 1);
  return Tagged(Tag::kCompound, copy);
}

std::optional<Word> Calculator::Normalize(Word word) {
  if (IsFlat(word)) return Apply(AddressOf(word), AddressOf(word) + 1);
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
    const auto value = Apply(block, values_.data() + values_.size() - arity);
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
    if (IsNumber(left) && IsNumber(right)) {
      if (NumberTerm(left).number() != NumberTerm(right).number()) return true;
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

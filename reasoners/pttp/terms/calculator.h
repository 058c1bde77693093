// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_CALCULATOR_H_
#define LATCHWORK_PTTP_CALCULATOR_H_

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "latchwork/logic/arithmetic.h"
#include "reasoners/pttp/terms/arena.h"
#include "reasoners/pttp/terms/functors.h"
#include "reasoners/pttp/terms/unifier.h"
#include "reasoners/pttp/terms/word.h"

namespace latchwork::pttp {

/// A number outside of any box.
struct Number {
  Tag tag = Tag::kInteger;  ///< kInteger or kReal.
  Word bits = 0;

  static Number In(Word boxed) { return {TagOf(boxed), *AddressOf(boxed)}; }
  static Number Real(double value) { return {Tag::kReal, std::bit_cast<Word>(value)}; }
  double real() const { return std::bit_cast<double>(bits); }
  bool IsFiniteReal() const { return tag == Tag::kReal && std::isfinite(real()); }
  /// Whether a double is what it is.
  bool IsExact() const {
    constexpr Word kBound = Word{1} << 53U;
    return tag == Tag::kReal ? std::isfinite(real()) : bits + kBound <= 2 * kBound;
  }
  double value() const {
    return tag == Tag::kReal ? real() : static_cast<double>(std::bit_cast<std::int64_t>(bits));
  }
};

/// Puts a number into a box.
Word Box(const Number& number, Arena& heap);

/// Ground arithmetic on words.
class Calculator {
 public:
  Calculator(const Functors& functors, Arena& heap) : functors_(&functors), heap_(&heap) {}

  static constexpr std::size_t kMostArguments = 2;
  /// Applies a function to as many numbers as it takes. False: no value.
  static bool Apply(logic::Arithmetic::Function function, const Number* numbers, std::size_t arity,
                    Number& result);
  static std::optional<bool> Decide(logic::Arithmetic::Predicate predicate, const Number* numbers,
                                    std::size_t arity) {
    if (arity == 2 && numbers[0].IsExact() && numbers[1].IsExact()) {
      return logic::Arithmetic::Evaluate(predicate, numbers[0].value(), numbers[1].value());
    }
    return DecideTerms(predicate, numbers, arity);
  }

  /// Evaluates the interpreted functions of a ground term; nothing when one has no value.
  std::optional<Word> Normalize(Word word);
  /// Nothing when an argument is not a number.
  static std::optional<bool> Decide(logic::Arithmetic::Predicate predicate, const Word* arguments,
                                    std::size_t arity);
  /// Whether two terms are known to be different, whatever their variables stand for: numbers and
  /// distinct objects by nature, constants and compound terms under the unique-names assumption
  /// only.
  bool Differ(Word a, Word b, bool unique_names);

 private:
  static std::optional<bool> DecideTerms(logic::Arithmetic::Predicate predicate,
                                         const Number* numbers, std::size_t arity);
  struct Visit {
    Word word;
    bool expanded;
  };
  std::optional<Word> Rebuild(const Word* block, const Word* arguments);

  const Functors* functors_;
  Arena* heap_;
  std::vector<Visit> visits_;
  std::vector<Word> values_;
  std::vector<std::pair<Word, Word>> pairs_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_CALCULATOR_H_

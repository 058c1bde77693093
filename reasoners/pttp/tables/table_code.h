// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLE_CODE_H_
#define LATCHWORK_PTTP_TABLE_CODE_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "latchwork/logic/arithmetic.h"
#include "reasoners/pttp/terms/calculator.h"
#include "reasoners/pttp/terms/functors.h"
#include "reasoners/pttp/terms/word.h"

namespace latchwork::pttp {

/// How deep the templates are that code is made for.
inline constexpr int kDeepestTemplate = 16;

/// A step of a calculation in postfix order.
struct Instruction {
  enum class Kind : std::uint8_t { kSlot, kNumber, kApply };
  Kind kind = Kind::kSlot;
  logic::Arithmetic::Function function{};
  std::uint32_t operand = 0;  ///< kSlot: which; kApply: how many arguments.
  Number number;
};

/// An argument whose slots all have values when it is needed.
struct Operand {
  enum class Kind : std::uint8_t {
    kWord,         ///< As it stands.
    kSlot,         ///< The value of a slot.
    kTemplate,     ///< Built from slots.
    kCalculation,  ///< A number.
    kMixed,        ///< Built, then its interpreted functions are evaluated.
  };
  Kind kind = Kind::kWord;
  std::uint32_t slot = 0;
  std::uint32_t argument = 0;  ///< Its place among the arguments of its literal.
  Word word = 0;               ///< The pattern.
  std::vector<Instruction> calculation;

  /// The value lies where nothing keeps it.
  bool is_fresh() const { return kind != Kind::kWord && kind != Kind::kSlot; }
};

/// A step of taking ground values apart.
struct MatchStep {
  enum class Kind : std::uint8_t {
    kBind,   ///< A slot gets the value.
    kSame,   ///< It is what a slot holds already.
    kEqual,  ///< It is a ground word.
    kOpen,   ///< It is a compound term with this header, whose arguments become parts.
  };
  Kind kind = Kind::kBind;
  bool of_part = false;      ///< The value is a part; else one of those that were given.
  std::uint32_t source = 0;  ///< Its number.
  std::uint32_t slot = 0;
  Word word = 0;
};

/// Matches values with patterns. Every slot that is met for the first time is bound.
struct MatchCode {
  static constexpr std::size_t kMostParts = 64;

  std::vector<MatchStep> steps;
  std::uint32_t parts = 0;
  bool binds_only = true;  ///< Every step is kBind, of a value that was given.
};

/// Makes code for one clause, whose slots it knows to be bound or not.
class CodeMaker {
 public:
  CodeMaker(const Functors& functors, std::size_t slots)
      : functors_(&functors), bound_(slots, false) {}

  /// All slots have values from here on.
  void BindAll() { bound_.assign(bound_.size(), true); }
  /// Whether a word has no slot without a value.
  bool IsBound(Word word) const;

  /// For a bound word. `computed`: interpreted functions in it are evaluated.
  Operand MakeOperand(Word word, std::uint32_t argument, bool computed) const;
  /// Code that matches the value of that number with a word, and binds its slots.
  void AddMatch(Word word, std::uint32_t source, MatchCode& pattern) {
    AddMatch(word, source, false, pattern);
  }
  /// A pattern had too many parts.
  bool failed() const { return failed_; }

 private:
  void AddMatch(Word word, std::uint32_t source, bool of_part, MatchCode& pattern);

  const Functors* functors_;
  std::vector<bool> bound_;
  bool failed_ = false;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLE_CODE_H_

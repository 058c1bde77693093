// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_RULE_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_RULE_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "latchwork/logic/arithmetic.h"
#include "latchwork/logic/clause.h"
#include "reasoners/circumscription/values/value.h"

namespace latchwork::circumscription {

constexpr std::size_t kNoIndex = SIZE_MAX;

/// A term of a rule. What is bound where is known beforehand: variables are visited from left to
/// right, so that the first visit of one binds it.
struct Pattern {
  enum class Kind : std::uint8_t { kValue, kBind, kRead, kCompound, kCompute };
  Kind kind = Kind::kValue;
  Value value;                            ///< Of kValue; compound values stand as kCompound.
  std::size_t variable = 0;               ///< Of kBind and kRead.
  logic::Symbol function;                 ///< Of kCompound.
  logic::Arithmetic::Function compute{};  ///< Of kCompute.
  std::vector<Pattern> arguments;
};

/// What a rule does next on the way to its instances.
struct Step {
  enum class Kind : std::uint8_t {
    kJoin,    ///< Some fact of `relation` matches the arguments.
    kAbsent,  ///< No fact does: a default.
    kCall,    ///< The attachment of `relation` is called with its inputs, then as kJoin.
    kTest,    ///< Arithmetic holds, or, negated, does not.
    kEqual,   ///< arguments[0], computed, matches arguments[1]; negated: both differ.
  };
  Kind kind = Kind::kJoin;
  bool negated = false;
  std::size_t relation = kNoIndex;
  std::vector<Pattern> arguments;
  std::size_t lookup = kNoIndex;   ///< A column whose value is known: its index is used.
  std::size_t ordinal = kNoIndex;  ///< Among the steps over relations of the rule's own stratum.
  logic::Arithmetic::Predicate test{};
  std::size_t literal = kNoIndex;  ///< In the clause.
};

struct Head {
  std::size_t relation = kNoIndex;
  std::vector<Pattern> arguments;
  std::size_t literal = kNoIndex;  ///< In the clause.
};

/// A clause laid out for finding its instances. Without heads: a constraint.
struct Rule {
  std::size_t clause = kNoIndex;
  std::vector<Step> steps;
  std::vector<Head> heads;
  std::vector<Head> open;  ///< Atoms that may hold or not.
  std::size_t variables = 0;
  std::size_t ordinals = 0;  ///< Number of steps over relations of its own stratum.
};

/// A predicate or an attachment.
struct RelationInfo {
  logic::PredicateName name;
  int level = 0;  ///< Of a minimized predicate: 1 is minimized first. 0: not minimized.
  bool is_fixed = false;
  bool is_concluded = false;  ///< Some clause has it as its head.
  std::size_t attachment = kNoIndex;
  std::vector<std::size_t> columns;  ///< That are looked up.
  std::size_t stratum = 0;
};

struct Stratum {
  std::vector<std::size_t> rules;
  std::vector<std::size_t> checks;  ///< Constraints that can be looked at after it.
  bool is_recursive = false;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_RULE_H_

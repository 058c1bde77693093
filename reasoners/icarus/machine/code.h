// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_CODE_H_
#define LATCHWORK_ICARUS_CODE_H_

#include <cstdint>
#include <vector>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

/// Addresses are indices into CompiledProgram::instructions.
using Address = std::uint32_t;

enum class Op : std::uint8_t {
  kCall,       ///< a: skill. b, c: its arguments, in CompiledProgram::terms.
  kTest,       ///< a: call, in CompiledProgram::calls.
  kBind,       ///< a: slot of the variable. b: term.
  kTakeApart,  ///< a: pattern, a list. b: term.
  kMatch,      ///< a: name of the head, or kNoName. b, c: the items of the pattern.
  kNot,        ///< a: where to go on. b: 1 for *notA*.
  kNotEnd,     ///< The negated clause is True.
  kObjective,  ///< a: what is asked when the objective is False. b: 1 when it is kTest only.
  kMeans,      ///< a, b: in CompiledProgram::branches.
  kSequence,   ///< a, b: the addresses of the steps, in CompiledProgram::branches.
  kStepEnd,    ///< The step is True.
  kAct,        ///< a, b: calls.
  kExit,       ///< The skill is True.
  kTopEnd,     ///< The top call is True.
  kFail,
};

struct Instruction {
  Op op = Op::kFail;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t c = 0;
  FormId form = kNoForm;
};

/// A term that the machine evaluates or matches.
struct TermCode {
  enum class Kind : std::uint8_t { kValue, kVariable, kAnything, kList, kCall, kCycle };
  Kind kind = Kind::kValue;
  std::uint32_t a = 0;  ///< kVariable: slot. kList: first item. kCall: in CompiledProgram::calls.
  std::uint32_t b = 0;  ///< kList: number of items.
  Value value;          ///< kValue.
};

/// The functions of the language, in the order of their signatures.
enum class Builtin : std::uint8_t {
  kEqual,
  kDiffers,
  kLess,
  kLessEqual,
  kGreater,
  kGreaterEqual,
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kMin,
  kMax,
  kAbs,
  kRound,
  kList,
  kMember,
  kStore,
  kForget,
  kUpdate,
};

struct CallCode {
  enum class Kind : std::uint8_t {
    kBuiltin,
    kChange,  ///< {forget} and {update}, whose patterns are not evaluated.
    kHost,
    kEffect,  ///< Of the host, and asked each time that it is met.
  };
  Kind kind = Kind::kHost;
  bool comparable = false;     ///< Its arguments are values and variables, and nothing else.
  std::uint32_t function = 0;  ///< Builtin, or index of the host's function.
  NameId name = kNoName;
  std::uint32_t first = 0;  ///< Arguments, in CompiledProgram::terms.
  std::uint32_t count = 0;
  std::uint32_t first_slot = 0;  ///< comparable: its variables, in CompiledProgram::slots.
  std::uint32_t slots = 0;
  FormId form = kNoForm;
};

/// An argument of a call that is a variable.
struct ArgumentSlot {
  std::uint32_t argument = 0;
  std::uint32_t slot = 0;
};

/// A means, or a step of a sequence: where its code is and which skill it calls.
struct Branch {
  Address address = 0;
  std::uint32_t skill = kNoSkill;
  std::uint32_t first = 0;  ///< Arguments of that skill, in CompiledProgram::terms.
  std::uint32_t count = 0;
};

struct SkillCode {
  Address entry = 0;
  std::uint32_t parameters = 0;
  std::uint32_t variables = 0;
  SkillType type = SkillType::kPlan;
  bool has_value = false;
  std::uint32_t value = 0;  ///< Term.
};

/// A program as the machine runs it.
struct CompiledProgram {
  std::vector<Instruction> instructions;
  std::vector<TermCode> terms;
  std::vector<CallCode> calls;
  std::vector<ArgumentSlot> slots;
  std::vector<Branch> branches;
  std::vector<SkillCode> skills;  ///< Of Program::skills.
  std::vector<Value> facts;
  bool has_sequences = false;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_CODE_H_

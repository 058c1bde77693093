// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_BINDING_TRACE_H_
#define LATCHWORK_ICARUS_BINDING_TRACE_H_

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"

namespace latchwork::icarus {

using Bits = std::vector<bool>;

/// A skill and which of its parameters are bound when it is called.
struct Mode {
  std::uint32_t skill = kNoSkill;
  Bits bound;

  bool operator<(const Mode& other) const {
    return skill != other.skill ? skill < other.skill : bound < other.bound;
  }
};

/// How a skill may be True: which of its parameters are bound in all the ways, and in some.
struct Exit {
  bool succeeds = false;
  Bits surely;
  Bits may;
};

/// What is known of the variables of a skill at one point of it.
struct Bindings {
  Bits surely;
  Bits may;
  bool dead = false;  ///< Something before is never True.
};

/// What a term is needed for.
struct Need {
  Code code = Code::kUnboundCall;
  std::string what;
};

/// Who follows a skill: knows what its calls come to, and hears where a value is missing.
class BindingListener {
 public:
  BindingListener() = default;
  BindingListener(const BindingListener&) = delete;
  BindingListener& operator=(const BindingListener&) = delete;
  virtual ~BindingListener() = default;

  virtual Exit Call(Mode mode, const Clause& clause) = 0;
  /// The term is a variable that is not surely bound, or `?`.
  virtual void Missing(const Term& term, const Need& need, const Bindings& bindings) = 0;
};

/// Follows a skill in the order in which its clauses are asked.
class BindingTrace {
 public:
  BindingTrace(const Program& program, BindingListener& listener)
      : program_(program), listener_(listener) {}

  /// Of a skill with clauses missing all is taken to be right.
  Exit Follow(const Skill& skill, const Bits& bound_parameters);

 private:
  Bindings Conjunction(const Skill& skill, Slot slot, Bindings bindings);
  /// Takes the parameters that were missed in one slot for bound in the others: once is enough.
  void Forgive(Bindings& bindings) const;
  void Ask(const Clause& clause, Bindings& bindings);
  void AskSkill(const Clause& clause, Bindings& bindings);
  void Require(const Term& term, const Need& need, Bindings& bindings);
  void RequireCall(const Term& call, Bindings& bindings);

  const Program& program_;
  BindingListener& listener_;
  Bits missed_;  ///< Parameters of the skill that is followed.
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_BINDING_TRACE_H_

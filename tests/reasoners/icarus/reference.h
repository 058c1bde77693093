// SPDX-License-Identifier: BSD-3-Clause
//
// The language as plainly as it can be written down: recursion over lists, no cleverness. What the
// interpreter does is compared with it.
#ifndef LATCHWORK_TESTS_REASONERS_ICARUS_REFERENCE_H_
#define LATCHWORK_TESTS_REASONERS_ICARUS_REFERENCE_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/interpreter.h"

namespace latchwork::icarus::testing {

/// A ground value: an atom as it is written, or a list.
struct Datum {
  std::string atom;
  std::vector<Datum> items;
  bool is_list = false;

  std::string Text() const;
  friend bool operator==(const Datum& a, const Datum& b) { return a.Text() == b.Text(); }
};

/// The host: the text of a call to its answer, "" for False.
using Answers = std::function<std::string(const std::string&)>;

class Reference {
 public:
  Reference(const Program& program, Answers answers, const RunOptions& options);

  /// One cycle of the skill `top`, whose parameters are left open.
  void Cycle(std::uint32_t top);

  std::vector<std::string> acts;          ///< In order; without repeats.
  std::vector<std::string> environments;  ///< What the parameters are bound to; `?`: nothing.
  std::string Memory() const;
  std::size_t clauses = 0;
  bool too_much = false;  ///< More clauses than a test should wait for.

 private:
  using Environment = std::vector<std::optional<Datum>>;
  /// What an act does to memory: {function pattern datum}.
  struct Change {
    std::string function;
    Datum pattern;  ///< `?` within stands for anything.
    Datum datum;
  };
  struct Outcome {
    bool is_act = false;
    Environment environment;
    std::string act;
    double value = 0;
    std::vector<Change> changes = {};
  };
  using Emit = std::function<void(const Outcome&)>;
  struct State {
    std::size_t step = 0;
    Environment environment;
    std::uint64_t touched = 0;
    bool ended = false;
  };

  void Apply(const Change& change);
  void Ask(const Clause& clause, const Environment& environment, const Emit& emit);
  void Conjunction(const std::vector<Clause>& clauses, std::size_t first,
                   const Environment& environment, const Emit& emit);
  void Call(const Clause& clause, const Environment& environment, const Emit& emit);
  void Body(std::uint32_t skill, const Environment& frame, const Emit& emit);
  void Plan(const Skill& skill, const Environment& frame, const Emit& emit);
  void Sequence(std::uint32_t skill, const Environment& frame, const Emit& emit);
  std::vector<Clause> Expanded(const std::vector<Clause>& means, const Environment& frame);
  double ValueOf(const Clause& means, const Environment& environment);
  std::optional<Datum> Pattern(const Term& term, const Environment& environment);
  void Action(const Skill& skill, const Environment& frame, const Emit& emit);
  void Negation(const Clause& clause, const Environment& environment, const Emit& emit);
  void Match(const Clause& clause, const Environment& environment, const Emit& emit);
  std::optional<Datum> Evaluate(const Term& term, const Environment& environment);
  std::optional<Datum> Function(const Term& call, const Environment& environment);
  bool Unify(const Term& term, const Datum& datum, Environment& environment);

  const Program& program_;
  Answers answers_;
  RunOptions options_;
  std::vector<Datum> memory_;
  std::map<std::string, State> states_;
  std::map<std::string, std::uint32_t> state_skills_;
  std::uint64_t cycle_ = 0;
  std::uint32_t depth_ = 0;
};

}  // namespace latchwork::icarus::testing

#endif  // LATCHWORK_TESTS_REASONERS_ICARUS_REFERENCE_H_

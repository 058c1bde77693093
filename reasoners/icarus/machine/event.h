// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_EVENT_H_
#define LATCHWORK_ICARUS_EVENT_H_

#include <cstdint>
#include <span>
#include <string_view>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

struct Act;

enum class EventKind : std::uint8_t {
  kCall,    ///< A skill is asked. values: its parameters.
  kTrue,    ///< A call is True. bindings. truth: passed on; else it had been True so already.
            ///< index: of its kCall event.
  kReturn,  ///< A call has come to its end. truth: it was True. acted: it acted. index: the same.
  kTest,    ///< A {call} as a clause. truth.
  kHost,    ///< The host is asked. name, values: arguments; answer; text: why it failed.
  kKnown,   ///< The same, answered earlier in this cycle.
  kBind,    ///< truth, bindings.
  kMatch,   ///< truth, bindings; answer: the fact. index: 1 where it is a further one.
  kNot,     ///< A negation has come to its end. truth; acted: its clause acted.
  kObjective,  ///< An objective has come to its end. truth: it was not False.
  kMeans,      ///< One of :means is asked. index, from 1; clause.
  kStep,       ///< A step of a :sequence is asked. index, from 1; past the last: it is finished.
  kStepEnd,    ///< truth: the sequence goes on to the next step. acted: the step acted.
  kStore,      ///< A fact enters memory. answer: the fact.
  kForget,     ///< A fact leaves memory. answer: the fact.
  kAct,        ///< An act is found. act.
  kDropped,    ///< An act goes no further than `in`. act.
  kTop,        ///< The top call is True. values: of its variables.
  kChosen,     ///< An act is what the cycle came to. act.
  kFault,      ///< text.
};
inline constexpr std::size_t kEventKinds = static_cast<std::size_t>(EventKind::kFault) + 1;

/// A variable of the skill in which an event is, and what it was bound to.
struct Binding {
  std::uint32_t variable = 0;
  Value value;
};

/// Something that happened in a cycle. What it refers to is valid while the sink is told.
struct Event {
  EventKind kind = EventKind::kFault;
  bool truth = false;
  bool acted = false;
  std::uint32_t number = 0;        ///< Within the cycle, from 1.
  std::uint32_t in = 0;            ///< The kCall event of the skill that it is in; 0: the top.
  std::uint32_t depth = 0;         ///< Skills that are being asked.
  std::uint32_t skill = kNoSkill;  ///< kCall, kTrue, kReturn: called. Acts: the :action.
  std::uint32_t body = kNoSkill;   ///< The skill that the clause is of; kNoSkill: the top.
  FormId form = kNoForm;           ///< The clause, of the program or, where `in` is 0, of the top.
  std::uint32_t index = 0;
  NameId name = kNoName;
  Value answer;
  std::span<const Value> values;
  std::span<const Binding> bindings;
  std::span<const Value> frame;  ///< The variables of `body`, as they are bound now.
  const Act* act = nullptr;
  std::string_view text;
};

/// Is told what happens in a cycle, as it happens.
class EventSink {
 public:
  virtual ~EventSink() = default;
  virtual void OnEvent(const Event& event) = 0;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_EVENT_H_

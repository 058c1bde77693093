// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_TRACE_ENTRY_H_
#define LATCHWORK_ICARUS_TRACE_ENTRY_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/event.h"
#include "reasoners/icarus/machine/value.h"
#include "reasoners/icarus/tools/clause_text.h"

namespace latchwork::icarus {

/// An event in words, which outlives its cycle.
struct TraceEntry {
  EventKind kind = EventKind::kFault;
  bool truth = false;
  bool acted = false;
  std::uint32_t number = 0;
  std::uint32_t in = 0;
  std::uint32_t depth = 0;
  std::uint32_t index = 0;
  std::uint32_t skill = kNoSkill;
  std::uint32_t body = kNoSkill;
  FormId form = kNoForm;
  std::uint32_t line = 0;  ///< Of the clause; 0: it is of the top.
  std::uint32_t column = 0;
  std::string clause;               ///< With its variables replaced.
  std::vector<std::string> values;  ///< kCall: arguments; an unbound one is its parameter's name.
  std::vector<std::pair<std::string, std::string>> bindings;
  std::string call;                   ///< kHost, kKnown: {function argument ...}.
  std::optional<std::string> answer;  ///< kHost, kKnown; absent: False. kMatch, kStore, kForget.
  std::string act;                    ///< {call} ...
  std::string text;                   ///< kFault; kHost: why it failed.
};

/// The words that events have in traces, in the order of EventKind.
std::string_view NameOf(EventKind kind);

/// Puts the events of one cycle into words.
class EventDescriber {
 public:
  /// `top` are the source and the variables of the top call; all outlive the describer.
  EventDescriber(const Program& program, const SourceTree& top,
                 std::span<const std::string> top_variables, const NamePool& names)
      : program_(program), top_(top), top_variables_(top_variables), names_(names) {}

  TraceEntry Describe(const Event& event) const;

 private:
  void SetClause(const Event& event, TraceEntry& entry) const;
  FormId StepForm(const Event& event) const;
  std::span<const std::string> VariablesOf(std::uint32_t body) const;

  const Program& program_;
  const SourceTree& top_;
  std::span<const std::string> top_variables_;
  const NamePool& names_;
};

/// One line without its end, indented by the depth of the skills: what was asked and what it came
/// to. Empty for what goes without saying.
std::string TraceLine(const TraceEntry& entry);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_TRACE_ENTRY_H_

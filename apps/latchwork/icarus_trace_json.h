// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_ICARUS_TRACE_JSON_H_
#define LATCHWORK_APPS_LATCHWORK_ICARUS_TRACE_JSON_H_

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/latchwork/icarus_session.h"
#include "reasoners/icarus/tools/trace_entry.h"

namespace latchwork::app {

/// The lines of a trace, one JSON object each. `kind` says what a line is: "trace", the first;
/// "cycle", what a cycle began with; an event; "result", what the cycle came to.
nlohmann::ordered_json TraceHeader(const IcarusSettings& settings, const IcarusSession& session);
nlohmann::ordered_json CycleToJson(const IcarusSession& session, std::size_t index);
nlohmann::ordered_json EventToJson(std::uint64_t cycle, const icarus::TraceEntry& entry);
nlohmann::ordered_json ResultToJson(const IcarusSession& session, std::size_t index,
                                    const icarus::CycleResult& result);
/// On one line; bytes that are no UTF-8 are replaced.
std::string ToLine(const nlohmann::ordered_json& json);

/// A trace that was read again.
struct RecordedTrace {
  struct Line {
    std::size_t number = 0;  ///< In the file, from 1.
    nlohmann::ordered_json json;
  };
  nlohmann::ordered_json options;
  std::string script;       ///< A script of a world that answers as the recorded one did.
  std::vector<Line> lines;  ///< After the header.
};

/// Nothing, with a message on standard error, when the text is no trace. `with_acts`: the script
/// expects the acts that each cycle came to.
std::optional<RecordedTrace> ReadTrace(const std::string& text, const std::string& file,
                                       bool with_acts = false);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_ICARUS_TRACE_JSON_H_

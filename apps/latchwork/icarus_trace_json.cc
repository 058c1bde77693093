// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/icarus_trace_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <utility>

namespace latchwork::app {

namespace {

using Json = nlohmann::ordered_json;
using icarus::EventKind;

constexpr std::string_view kFormat = "latchwork icarus";
constexpr int kVersion = 1;

Json ValueTexts(const std::vector<icarus::Value>& values, const icarus::NamePool& names) {
  Json texts = Json::array();
  for (const icarus::Value& value : values) texts.push_back(icarus::ToString(value, names));
  return texts;
}

/// The text of the call that a cycle begins with; null: none.
Json TopText(const IcarusSession& session, std::size_t top) {
  if (top == icarus::Interpreter::kNoTop) return nullptr;
  return session.interpreter->TopText(top);
}

bool TellsTruth(EventKind kind) {
  return kind == EventKind::kTrue || kind == EventKind::kReturn || kind == EventKind::kTest ||
         kind == EventKind::kBind || kind == EventKind::kMatch || kind == EventKind::kNot ||
         kind == EventKind::kObjective || kind == EventKind::kStepEnd;
}

/// Writes a script while a trace is read.
class ScriptWriter {
 public:
  explicit ScriptWriter(bool with_acts) : with_acts_(with_acts) {}

  void Header(const Json& header) {
    script_ = "(functions";
    for (const Json& name : header.at("functions")) script_ += ' ' + name.get<std::string>();
    script_ += ")\n";
  }

  void Line(const Json& line) {
    const std::string& kind = line.at("kind").get_ref<const std::string&>();
    if (kind == "cycle") {
      Cycle(line);
    } else if (kind == "host" && open_) {
      Answer(line);
    } else if (kind == "result" && open_ && with_acts_ && !line.at("acts").empty()) {
      script_ += " (expect";
      for (const Json& act : line.at("acts")) script_ += ' ' + act.get<std::string>();
      script_ += ')';
    }
  }

  std::string Finish() {
    if (open_) script_ += ")\n";
    open_ = false;
    return std::move(script_);
  }

 private:
  void Cycle(const Json& line) {
    if (open_) script_ += ")\n";
    open_ = true;
    script_ += "(cycle";
    for (const Json& pattern : line.at("forget")) Item("forget", pattern);
    for (const Json& pair : line.at("update")) {
      script_ +=
          " (update " + pair.at(0).get<std::string>() + ' ' + pair.at(1).get<std::string>() + ')';
    }
    for (const Json& fact : line.at("store")) Item("store", fact);
    if (line.at("top").is_null()) {
      script_ += " (idle)";
    } else if (line.at("top") != top_) {
      top_ = line.at("top");
      Item("top", top_);
    }
  }

  void Answer(const Json& line) {
    const auto call = line.at("call").get<std::string>();
    const Json& answer = line.at("answer");
    if (line.contains("text")) {
      script_ += ' ' + icarus::FailureItem(call, line.at("text").get<std::string>());
    } else {
      Item("answer", call + ' ' + (answer.is_null() ? "nil" : answer.get<std::string>()));
    }
  }

  void Item(const char* head, const Json& text) {
    script_ += fmt::format(" ({} {})", head, text.get<std::string>());
  }

  const bool with_acts_;
  std::string script_;
  bool open_ = false;
  Json top_;
};

bool IsHeader(const Json& json) {
  return json.is_object() && json.value("kind", "") == "trace" &&
         json.value("format", "") == kFormat && json.value("version", 0) == kVersion &&
         json.contains("options");
}

}  // namespace

std::string ToLine(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json TraceHeader(const IcarusSettings& settings, const IcarusSession& session) {
  Json functions = Json::array();
  for (const icarus::Signature& function : session.script.functions) {
    functions.push_back(std::string(function.name));
  }
  return {{"kind", "trace"},
          {"format", kFormat},
          {"version", kVersion},
          {"program", settings.program},
          {"options", OptionsToJson(settings)},
          {"functions", std::move(functions)}};
}

Json CycleToJson(const IcarusSession& session, std::size_t index) {
  const icarus::ScriptCycle& cycle = session.script.cycles[index];
  Json updates = Json::array();
  for (const auto& [pattern, fact] : cycle.updated) {
    updates.push_back(
        {icarus::ToString(pattern, session.names), icarus::ToString(fact, session.names)});
  }
  return {{"kind", "cycle"},
          {"cycle", session.interpreter->cycle() + 1},
          {"top", TopText(session, session.tops[index])},
          {"forget", ValueTexts(cycle.forgotten, session.names)},
          {"update", std::move(updates)},
          {"store", ValueTexts(cycle.stored, session.names)}};
}

Json EventToJson(std::uint64_t cycle, const icarus::TraceEntry& entry) {
  Json json = {{"kind", icarus::NameOf(entry.kind)},
               {"cycle", cycle},
               {"event", entry.number},
               {"in", entry.in},
               {"depth", entry.depth}};
  if (entry.line != 0) json["at"] = fmt::format("{}:{}", entry.line, entry.column);
  if (!entry.clause.empty()) json["clause"] = entry.clause;
  if (!entry.call.empty()) json["call"] = entry.call;
  if (entry.index != 0) json["index"] = entry.index;
  if (TellsTruth(entry.kind)) json["true"] = entry.truth;
  if (entry.acted) json["acted"] = true;
  for (const auto& [name, value] : entry.bindings) json["bindings"][name] = value;
  const bool asked = entry.kind == EventKind::kHost || entry.kind == EventKind::kKnown;
  if (entry.answer) {
    json["answer"] = *entry.answer;
  } else if (asked) {
    json["answer"] = nullptr;
  }
  if (!entry.act.empty()) json["act"] = entry.act;
  if (!entry.text.empty()) json["text"] = entry.text;
  return json;
}

Json ResultToJson(const IcarusSession& session, std::size_t index,
                  const icarus::CycleResult& result) {
  return {{"kind", "result"},
          {"cycle", session.interpreter->cycle()},
          {"acts", Texts(result.acts, session.names)},
          {"stopped", Texts(result.stopped, session.names)},
          {"true", TopBindings(*session.interpreter, session.names, session.tops[index], result)},
          {"clauses", result.clauses},
          {"faults", result.fault_count},
          {"aborted", result.is_aborted}};
}

std::optional<RecordedTrace> ReadTrace(const std::string& text, const std::string& file,
                                       bool with_acts) {
  RecordedTrace trace;
  ScriptWriter writer(with_acts);
  std::size_t number = 0;
  bool headed = false;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line(text.data() + begin, end - begin);
    begin = end + 1;
    ++number;
    if (line.empty()) continue;
    try {
      Json json = Json::parse(line);
      if (!headed) {
        headed = IsHeader(json);
        if (!headed) break;
        writer.Header(json);
        trace.options = json.at("options");
      } else {
        writer.Line(json);
        trace.lines.push_back({number, std::move(json)});
      }
    } catch (const Json::exception&) {
      fmt::print(stderr, "{}:{}: error: this is no line of a trace\n", file, number);
      return std::nullopt;
    }
  }
  if (!headed) {
    fmt::print(stderr, "{}: error: this is no trace, as 'icarus trace --json' prints it\n", file);
    return std::nullopt;
  }
  trace.script = writer.Finish();
  return trace;
}

}  // namespace latchwork::app

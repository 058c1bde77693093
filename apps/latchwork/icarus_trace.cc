// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "apps/latchwork/icarus_command.h"
#include "apps/latchwork/icarus_session.h"
#include "apps/latchwork/icarus_trace_json.h"
#include "reasoners/icarus/tools/trace_entry.h"

namespace latchwork::app {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  IcarusSettings common;
  std::string replay;
  std::string level = "clause";
  bool json = false;
};

/// Hands the events of each cycle on, in words.
class Tracer : public icarus::EventSink {
 public:
  using Take = std::function<void(const icarus::TraceEntry&)>;

  Tracer(const IcarusSession& session, Take take) : session_(session), take_(std::move(take)) {}

  void Begin(std::size_t top) {
    describer_.reset();
    if (top == icarus::Interpreter::kNoTop) return;
    describer_.emplace(session_.program.program, session_.interpreter->TopSource(top),
                       session_.interpreter->TopVariables(top), session_.names);
  }
  void OnEvent(const icarus::Event& event) override {
    if (describer_) take_(describer_->Describe(event));
  }

 private:
  const IcarusSession& session_;
  Take take_;
  std::optional<icarus::EventDescriber> describer_;
};

/// Calls `begin`, then runs the cycle, then calls `end`, for each cycle, until one says false.
template <typename Begin, typename End>
void ForCycles(IcarusSession& session, Tracer& tracer, const Begin& begin, const End& end) {
  session.interpreter->SetSink(&tracer);
  for (std::size_t i = 0; i < session.script.cycles.size(); ++i) {
    for (std::int64_t n = 0; n < session.script.cycles[i].repeat; ++n) {
      if (!begin(i)) return;
      tracer.Begin(session.tops[i]);
      if (!end(i, RunCycle(session, i))) return;
    }
  }
}

bool IsShown(const Settings& settings, icarus::EventKind kind) {
  using icarus::EventKind;
  if (settings.level != "skill") return true;
  return kind == EventKind::kCall || kind == EventKind::kTrue || kind == EventKind::kReturn ||
         kind == EventKind::kStep || kind >= EventKind::kAct;
}

int PrintTrace(const Settings& settings) {
  const auto session = std::make_unique<IcarusSession>();
  if (!OpenSession(settings.common, *session)) return kInvalidInput;
  if (settings.json) fmt::print("{}\n", ToLine(TraceHeader(settings.common, *session)));
  Tracer tracer(*session, [&](const icarus::TraceEntry& entry) {
    if (settings.json) {
      fmt::print("{}\n", ToLine(EventToJson(session->interpreter->cycle(), entry)));
      return;
    }
    const std::string line = icarus::TraceLine(entry);
    if (!line.empty() && IsShown(settings, entry.kind)) fmt::print("{}\n", line);
  });
  std::size_t unmet = 0;
  ForCycles(
      *session, tracer,
      [&](std::size_t i) {
        if (settings.json) fmt::print("{}\n", ToLine(CycleToJson(*session, i)));
        if (!settings.json) fmt::print("cycle {}\n", session->interpreter->cycle() + 1);
        return true;
      },
      [&](std::size_t i, const icarus::CycleResult& result) {
        fmt::print("{}\n", settings.json ? ToLine(ResultToJson(*session, i, result))
                                         : CycleLine(*session->interpreter, session->names,
                                                     session->tops[i], result));
        if (!IsAsExpected(*session, i, result)) ++unmet;
        return true;
      });
  return unmet == 0 ? kDone : kGoalNotReached;
}

/// Compares what happens now with a trace, line by line.
class Comparison {
 public:
  explicit Comparison(const RecordedTrace& trace) : trace_(trace) {}

  /// False once something differs.
  bool Take(Json now) {
    if (diverged_) return false;
    now.erase("at");
    Json recorded = next_ < trace_.lines.size() ? trace_.lines[next_].json : Json();
    if (recorded.is_object()) recorded.erase("at");
    if (ToLine(recorded) == ToLine(now)) {
      ++next_;
      return true;
    }
    diverged_ = true;
    recorded_ = ToLine(recorded);
    now_ = ToLine(now);
    place_ = fmt::format("cycle {}", now.at("cycle").get<std::uint64_t>());
    if (now.contains("event")) {
      place_ += fmt::format(", event {}", now.at("event").get<std::uint32_t>());
    }
    return false;
  }

  int Report(const std::string& file, std::uint64_t cycles) const {
    if (!diverged_ && next_ == trace_.lines.size()) {
      fmt::print("identical: {} cycle{}, {} lines\n", cycles, cycles == 1 ? "" : "s", next_);
      return kDone;
    }
    const std::size_t line =
        next_ < trace_.lines.size() ? trace_.lines[next_].number : trace_.lines.size() + 2;
    fmt::print("{}:{}: diverged in {}\n  recorded: {}\n  now:      {}\n", file, line,
               diverged_ ? place_ : fmt::format("cycle {}", cycles),
               diverged_ ? recorded_ : ToLine(trace_.lines[next_].json),
               diverged_ ? now_ : "nothing");
    return kDiverged;
  }

 private:
  const RecordedTrace& trace_;
  std::size_t next_ = 0;
  bool diverged_ = false;
  std::string place_;
  std::string recorded_;
  std::string now_;
};

int Replay(Settings settings) {
  const std::optional<std::string> text = ReadProgramText(settings.replay);
  if (!text) return kInvalidInput;
  const std::optional<RecordedTrace> trace = ReadTrace(*text, settings.replay);
  if (!trace || !OptionsFromJson(trace->options, settings.common)) return kInvalidInput;
  const auto session = std::make_unique<IcarusSession>();
  if (!OpenSession(settings.common, trace->script, settings.replay, *session)) {
    return kInvalidInput;
  }
  Comparison comparison(*trace);
  Tracer tracer(*session, [&](const icarus::TraceEntry& entry) {
    comparison.Take(EventToJson(session->interpreter->cycle(), entry));
  });
  ForCycles(
      *session, tracer, [&](std::size_t i) { return comparison.Take(CycleToJson(*session, i)); },
      [&](std::size_t i, const icarus::CycleResult& result) {
        return comparison.Take(ResultToJson(*session, i, result));
      });
  return comparison.Report(settings.replay, session->interpreter->cycle());
}

int Run(const Settings& settings) {
  if (!settings.replay.empty()) return Replay(settings);
  if (!settings.common.script.empty()) return PrintTrace(settings);
  fmt::print(stderr, "latchwork: give --script WORLD, or --replay TRACE\n");
  return kUsage;
}

}  // namespace

void AddIcarusTrace(CLI::App& icarus, Context& context) {
  CLI::App* command = icarus.add_subcommand(
      "trace", "Run a program in a scripted world and print all that happens in each cycle");
  const auto settings = std::make_shared<Settings>();
  command->footer(
      "Each line begins with the line and column of its clause. A trace in JSON, an object per\n"
      "line, holds what the sensors answered: --replay runs the program with those answers and\n"
      "names the first cycle and event that differ (exit code 6).\n"
      "Examples:\n"
      "  latchwork icarus trace bumper.icarus --script day.world\n"
      "  latchwork icarus trace bumper.icarus --script day.world --json > day.jsonl\n"
      "  latchwork icarus trace --replay day.jsonl bumper.icarus");
  command->add_option("PROGRAM", settings->common.program, "Program")->required();
  CLI::Option* const script = command->add_option("--script", settings->common.script,
                                                  "What the world does, cycle by cycle");
  CLI::Option* const replay =
      command
          ->add_option("--replay", settings->replay,
                       "A trace in JSON to run again, with the options that it holds, and compare")
          ->excludes(script);
  AddIcarusOptions(*command, settings->common);
  for (const char* const name : {"--top", "--acts", "--expand", "--means", "--faults",
                                 "--max-depth", "--max-clauses", "--restart", "--full"}) {
    replay->excludes(command->get_option(name));
  }
  command->add_option("--level", settings->level, "What is printed as text: clause or skill")
      ->check(CLI::IsMember({"clause", "skill"}));
  command->add_flag("--json", settings->json, "Print JSON, an object per line");
  command->callback([settings, &context] {
    TakeModes(settings->common);
    context.exit_code = Run(*settings);
  });
}

}  // namespace latchwork::app

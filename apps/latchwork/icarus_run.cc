// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/latchwork/icarus_command.h"
#include "apps/latchwork/icarus_session.h"
#include "reasoners/icarus/tools/profile.h"

namespace latchwork::app {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  IcarusSettings common;
  bool json = false;
  bool profile = false;
};

void PrintJson(const IcarusSession& session, std::size_t top, const icarus::CycleResult& result,
               bool met) {
  Json line = {{"cycle", session.interpreter->cycle()},
               {"acts", Texts(result.acts, session.names)},
               {"stopped", Texts(result.stopped, session.names)},
               {"true", TopBindings(*session.interpreter, session.names, top, result)},
               {"clauses", result.clauses},
               {"faults", result.fault_count},
               {"aborted", result.is_aborted},
               {"expected", met}};
  fmt::print("{}\n", line.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void Complain(const Settings& settings, const IcarusSession& session,
              const icarus::ScriptCycle& cycle) {
  std::string wanted;
  for (const std::string& word : *cycle.expected) wanted += ' ' + word;
  fmt::print(stderr, "{}:{}: cycle {} is not as expected:{}\n", settings.common.script, cycle.line,
             session.interpreter->cycle(), wanted);
}

/// Counts the unmet expectations.
class Runner {
 public:
  Runner(const Settings& settings, IcarusSession& session)
      : settings_(settings), session_(session) {}

  /// False: the program is not to go on.
  bool Cycle(std::size_t index) {
    const icarus::CycleResult& result = RunCycle(session_, index);
    const bool met = IsAsExpected(session_, index, result);
    if (settings_.json) {
      PrintJson(session_, session_.tops[index], result, met);
    } else {
      fmt::print("{}\n",
                 CycleLine(*session_.interpreter, session_.names, session_.tops[index], result));
    }
    PrintFaults(session_, result);
    if (!met) {
      ++unmet_;
      Complain(settings_, session_, session_.script.cycles[index]);
    }
    const bool stop = settings_.common.options.faults == icarus::FaultMode::kStop;
    if (stop && result.is_aborted) ++unmet_;
    return !stop || !result.is_aborted;
  }

  std::size_t unmet() const { return unmet_; }

 private:
  const Settings& settings_;
  IcarusSession& session_;
  std::size_t unmet_ = 0;
};

void RunCycles(const IcarusSession& session, Runner& runner) {
  for (std::size_t i = 0; i < session.script.cycles.size(); ++i) {
    for (std::int64_t n = 0; n < session.script.cycles[i].repeat; ++n) {
      if (!runner.Cycle(i)) return;
    }
  }
}

int Run(const Settings& settings) {
  const auto session = std::make_unique<IcarusSession>();
  if (!OpenSession(settings.common, *session)) return kInvalidInput;
  icarus::SkillProfile profile(session->program.program);
  if (settings.profile) session->interpreter->SetSink(&profile);
  Runner runner(settings, *session);
  RunCycles(*session, runner);
  if (settings.profile) fmt::print(stderr, "{}", profile.Table());
  return runner.unmet() == 0 ? kDone : kGoalNotReached;
}

}  // namespace

void AddIcarusRun(CLI::App& icarus, Context& context) {
  CLI::App* command = icarus.add_subcommand(
      "run", "Run a program in a scripted world; exit with 1 when it does not do what is expected");
  const auto settings = std::make_shared<Settings>();
  command->footer(
      "The script is a table of what the sensors answer and what enters memory, cycle by cycle:\n"
      "  (top (Near car1))\n"
      "  (cycle (answer {range-to car1} 3.0) (store (car car1)) (expect {goforward}))\n"
      "Examples:\n"
      "  latchwork icarus run bumper.icarus --script day.world\n"
      "  latchwork icarus run bumper.icarus --script day.world --acts all --profile");
  command->add_option("PROGRAM", settings->common.program, "Program; - is standard input")
      ->required();
  command->add_option("--script", settings->common.script, "What the world does, cycle by cycle")
      ->required();
  AddIcarusOptions(*command, settings->common);
  command->add_flag("--json", settings->json, "Print one JSON object per cycle");
  command->add_flag("--profile", settings->profile,
                    "At the end, a table to standard error: calls, clauses and acts of each skill");
  command->callback([settings, &context] {
    TakeModes(settings->common);
    context.exit_code = Run(*settings);
  });
}

}  // namespace latchwork::app

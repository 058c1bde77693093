// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/latchwork/icarus_command.h"
#include "apps/latchwork/icarus_layers.h"
#include "apps/latchwork/icarus_session.h"
#include "apps/latchwork/progress.h"
#include "apps/latchwork/run_agent.h"
#include "apps/latchwork/settings.h"
#include "latchwork/plugin/plugin_search.h"
#include "latchwork/schedule/lockstep.h"
#include "reasoners/icarus/icarus_options.h"
#include "reasoners/icarus/icarus_reasoner.h"
#include "reasoners/icarus/tools/script_recorder.h"

namespace latchwork::app {
namespace {

struct Settings {
  RunRequest run;
  std::string scenario;
  std::vector<std::string> settings;
  std::string layer;
  bool quiet = false;
};

/// The cycles of one layer, with the ticks in which it was asked.
class Recording : public schedule::RunObserver {
 public:
  Recording(std::size_t layer, const icarus::ScriptRecorder& recorder, const Settings& settings,
            std::uint64_t ticks)
      : layer_(layer), recorder_(recorder), progress_("record", settings.quiet), all_(ticks) {}

  bool OnTick(const schedule::TickRecord& record) override {
    for (const schedule::DecisionRecord& each : record.decisions) {
      if (each.layer != layer_) continue;
      text_ += fmt::format("{}  ; tick {}\n", recorder_.cycle(), record.tick);
      ticks_.push_back(record.tick);
    }
    progress_.Update(record.tick + 1, all_);
    return true;
  }

  const std::string& text() const { return text_; }
  const std::vector<std::uint64_t>& ticks() const { return ticks_; }

 private:
  std::size_t layer_;
  const icarus::ScriptRecorder& recorder_;
  Progress progress_;
  std::uint64_t all_;
  std::string text_;
  std::vector<std::uint64_t> ticks_;
};

/// The settings under which the tools do what the layer's reasoner does.
IcarusSettings ToolSettings(const config::ReasonerDescription& reasoner, const sdk::Body& body) {
  IcarusSettings settings;
  settings.program = body.files.front().string();
  settings.acts = reasoner.parameters.Text("acts");
  settings.expand = reasoner.parameters.Text("expand");
  settings.faults = reasoner.parameters.Text("faults");
  settings.full = reasoner.parameters.Boolean("full");
  settings.options = icarus::OptionsFrom(reasoner.parameters);
  settings.options.max_depth = reasoner.depth;
  settings.options.max_clauses = reasoner.inferences;
  return settings;
}

/// Those that are not as they are by default.
std::string OptionsText(const IcarusSettings& settings) {
  const icarus::RunOptions& options = settings.options;
  const icarus::RunOptions usual;
  std::string text;
  if (settings.acts != "first") text += " --acts " + settings.acts;
  if (settings.expand != "all") {
    text += fmt::format(" --expand {} --means {}", settings.expand, options.means);
  }
  if (settings.faults != "false") text += " --faults " + settings.faults;
  if (options.restart) text += " --restart";
  if (settings.full) text += " --full";
  if (options.max_depth != usual.max_depth) {
    text += fmt::format(" --max-depth {}", options.max_depth);
  }
  if (options.max_clauses != usual.max_clauses) {
    text += fmt::format(" --max-clauses {}", options.max_clauses);
  }
  return text;
}

/// Where it came from, how to run it, and the functions that the program may call.
std::string Heading(const Settings& settings, const IcarusSettings& tool, const sdk::Body& body) {
  std::string text = fmt::format(
      "; The cycles of layer {} in: {}\n; Run this script with:\n"
      ";   latchwork icarus run {} --script FILE{}\n",
      settings.layer, CommandOf(settings.run), tool.program, OptionsText(tool));
  if (body.attachments.empty()) return text;
  text += "(functions";
  for (const auto& attachment : body.attachments) text += ' ' + attachment->signature().predicate;
  return text + ")\n";
}

/// What a script cannot hold; an empty message: nothing.
logic::Diagnostic Obstacle(const config::LayerDescription& layer, const sdk::Body& body) {
  const sdk::Parameters& parameters = layer.reasoner.parameters;
  if (body.files.size() != 1) {
    return {layer.place,
            fmt::format("the program of layer '{}' is in {} files", layer.name, body.files.size()),
            "a script is run with a program of one file: put them together", ""};
  }
  if (parameters.Boolean("learn") || !parameters.Text("values").empty()) {
    return {layer.reasoner.place, "learned values have no place in a script",
            "record the layer without the parameters 'learn' and 'values' of its reasoner", ""};
  }
  return {};
}

/// Runs the script as the other tools do; says where it comes out otherwise.
int Verify(const IcarusSettings& tool, const std::string& script, const Recording& recording) {
  const auto session = std::make_unique<IcarusSession>();
  if (!OpenSession(tool, script, "the recording", *session)) return kInternalError;
  for (std::size_t i = 0; i < session->script.cycles.size(); ++i) {
    const icarus::CycleResult& result = RunCycle(*session, i);
    if (IsAsExpected(*session, i, result)) continue;
    fmt::print(stderr,
               "the recording: error: in cycle {} (tick {}) the program does otherwise than in the "
               "layer\n  layer:  {}\n  script: {}\n  hint: are the answers of its attachments "
               "functions of their arguments and of what they ask?\n",
               i + 1, recording.ticks()[i], fmt::join(*session->script.cycles[i].expected, " "),
               fmt::join(icarus::Outcome(result, session->names), " "));
    return kDiverged;
  }
  return kDone;
}

/// The layer that is recorded.
struct Subject {
  std::size_t index = 0;
  sdk::Body body;
  IcarusSettings tool;
  std::shared_ptr<icarus::IcarusReasoner> reasoner;
};

/// Puts a reasoner that can be watched, which that of a plugin cannot, in the place of the layer's.
logic::Diagnostics MakeSubject(const std::string& name, schedule::Agent& agent, Subject& subject) {
  logic::Diagnostic wrong = WrongIcarusLayer(agent.description, name, "runs programs");
  if (!wrong.message.empty()) return {std::move(wrong)};
  const auto& layers = agent.description.layers;
  const auto layer = std::ranges::find(layers, name, &config::LayerDescription::name);
  subject.index = static_cast<std::size_t>(layer - layers.begin());
  subject.body = agent.layers[subject.index].body;
  wrong = Obstacle(*layer, subject.body);
  if (!wrong.message.empty()) return {std::move(wrong)};
  subject.tool = ToolSettings(layer->reasoner, subject.body);
  subject.reasoner = std::make_shared<icarus::IcarusReasoner>();
  agent.layers[subject.index].reasoner = subject.reasoner;
  return subject.reasoner->Load(subject.body, layer->reasoner.parameters, *agent.symbols);
}

int Refuse(const logic::Diagnostics& diagnostics, int exit_code) {
  fmt::print(stderr, "{}", logic::Format(diagnostics));
  return exit_code;
}

int Record(const Settings& settings, const Context& context) {
  const plugin::Registry registry(
      plugin::MakeSearchPath(context.plugin_folders, context.executable));
  logic::SymbolTable symbols;
  auto [agent, diagnostics, exit_code] = PrepareAgent(settings.run, registry, symbols);
  if (!agent) return Refuse(diagnostics, exit_code);
  Subject subject;
  diagnostics = MakeSubject(settings.layer, *agent, subject);
  if (!diagnostics.empty()) return Refuse(diagnostics, kInvalidInput);
  icarus::ScriptRecorder recorder(subject.reasoner->program(), subject.reasoner->names());
  subject.reasoner->SetWatch(&recorder);
  Recording recording(subject.index, recorder, settings,
                      settings.run.ticks.value_or(agent->description.max_ticks));
  schedule::LockstepOptions options;
  options.max_ticks = settings.run.ticks;
  options.observers.push_back(&recording);
  schedule::Lockstep(*std::move(agent), options).Run();
  const std::string script = Heading(settings, subject.tool, subject.body) + recording.text();
  fmt::print("{}", script);
  return Verify(subject.tool, script, recording);
}

void AddOptions(CLI::App& command, Settings& settings) {
  command.add_option("AGENT", settings.run.agent_file, "Agent file (XML)")->required();
  command.add_option("--layer", settings.layer, "The layer; its reasoner is icarus")->required();
  command.add_option("--seed", settings.run.seed, "Of everything random in the world (default 1)")
      ->check(WholeNumber());
  command.add_option("--scenario", settings.scenario,
                     "Fragment file whose overrides and events come on top");
  command
      .add_option("--ticks", settings.run.ticks,
                  "Stop after so many ticks instead of the agent's duration")
      ->check(WholeNumber(1));
  command
      .add_option("--set", settings.settings, "PART.NAME=VALUE: a parameter, as in world.people=4")
      ->allow_extra_args(false);
  command.add_flag("-q,--quiet", settings.quiet, "No progress");
}

}  // namespace

void AddIcarusRecord(CLI::App& icarus, Context& context) {
  CLI::App* command = icarus.add_subcommand(
      "record", "Run an agent in its world, and print what a layer saw and did as a world script");
  const auto settings = std::make_shared<Settings>();
  command->footer(
      "A run is the same each time, so that of 'latchwork run' with the same options can be "
      "looked\n"
      "into: the script holds what the layer's latches brought, what its attachments answered, "
      "and\n"
      "what the program came to. run, trace and repl (why, why-not) take it, and so does "
      "recognise.\n"
      "It is run at once: the exit code is 0 when every cycle came out as in the layer, else 6.\n"
      "Examples:\n"
      "  latchwork icarus record examples/icarus/hanoi.xml --layer player --seed 7 > hanoi.world\n"
      "  latchwork icarus repl plugins/hanoi_player/hanoi_player.icarus --script hanoi.world");
  AddOptions(*command, *settings);
  command->callback([settings, &context] {
    if (!settings->scenario.empty()) settings->run.scenario = settings->scenario;
    settings->run.overrides = ParseSettings(settings->settings);
    context.exit_code = Record(*settings, context);
  });
}

}  // namespace latchwork::app

// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/latchwork/command.h"
#include "apps/latchwork/run_agent.h"
#include "apps/latchwork/settings.h"
#include "latchwork/logic/tptp.h"
#include "latchwork/plugin/plugin_search.h"
#include "latchwork/plugin/registry.h"
#include "latchwork/schedule/lockstep.h"
#include "latchwork/sdk/explanation.h"

namespace latchwork::app {
namespace {

struct ExplainOptions {
  std::filesystem::path agent;
  std::string scenario;
  std::uint64_t seed = 1;
  std::uint64_t tick = 0;
  std::string layer;
  std::string why_not;
  std::vector<std::string> settings;
  bool json = false;
};

/// Asks the reasoners about their decisions at one tick, while those are their last.
class Interview : public schedule::RunObserver {
 public:
  Interview(const ExplainOptions& options, const schedule::Agent& agent,
            std::optional<logic::Atom> why_not)
      : options_(options), why_not_(std::move(why_not)) {
    for (std::size_t i = 0; i < agent.layers.size(); ++i) {
      names_.push_back(agent.description.layers[i].name);
      reasoners_.push_back(agent.layers[i].reasoner);
    }
  }

  bool OnTick(const schedule::TickRecord& record) override {
    if (record.tick < options_.tick) return true;
    for (const schedule::DecisionRecord& each : record.decisions) {
      if (options_.layer.empty() || names_[each.layer] == options_.layer) Ask(each);
    }
    return false;
  }

  const std::string& text() const { return text_; }

 private:
  void Ask(const schedule::DecisionRecord& record) {
    const sdk::Decision& decision = *record.decision;
    sdk::Reasoner& reasoner = *reasoners_[record.layer];
    Say(fmt::format("layer {}: {}{}{}\n", names_[record.layer], sdk::Name(decision.status),
                    decision.message.empty() ? "" : ", ", decision.message));
    for (std::size_t i = 0; i < decision.conclusions.size(); ++i) {
      sdk::Explanation explanation{logic::ToString(decision.conclusions[i].fact), true, {}, {}};
      explanation.derivation = reasoner.Explain(i);
      Say(explanation, record.layer, "conclusion");
    }
    for (std::size_t i = 0; i < decision.assumptions.size(); ++i) {
      const auto explanation = reasoner.ExplainAssumption(i);
      const sdk::Assumption& assumption = decision.assumptions[i];
      Say(explanation.value_or(
              sdk::Explanation{logic::ToString(assumption.atom),
                               assumption.state == sdk::Assumption::State::kRetracted,
                               {},
                               {}}),
          record.layer, fmt::format("assumption, {}", sdk::Name(assumption.state)));
    }
    if (!why_not_) return;
    if (const auto explanation = reasoner.WhyNot(*why_not_)) {
      Say(*explanation, record.layer, "why not");
    } else {
      Say(fmt::format("layer {}: its reasoner keeps no reasons for what it does not conclude\n",
                      names_[record.layer]));
    }
  }

  void Say(const std::string& line) {
    if (!options_.json) text_ += line;
  }
  void Say(const sdk::Explanation& explanation, std::size_t layer, const std::string& what) {
    if (options_.json) {
      text_ += fmt::format("{{\"layer\":\"{}\",\"what\":\"{}\",\"explanation\":{}}}\n",
                           names_[layer], what, ToJson(explanation));
    } else {
      text_ += fmt::format("{}: {}", what, ToText(explanation));
    }
  }

  const ExplainOptions& options_;
  std::optional<logic::Atom> why_not_;
  std::vector<std::string> names_;
  std::vector<std::shared_ptr<sdk::Reasoner>> reasoners_;
  std::string text_;
};

int Explain(const ExplainOptions& options, const Context& context) {
  const plugin::Registry registry(
      plugin::MakeSearchPath(context.plugin_folders, context.executable));
  logic::SymbolTable symbols;
  std::optional<logic::Atom> why_not;
  if (!options.why_not.empty()) {
    auto read = logic::ReadTptpAtom(options.why_not, "--why-not", symbols);
    if (!read.atom) {
      fmt::print(stderr, "{}", logic::Format(read.diagnostics));
      return kUsage;
    }
    why_not = std::move(read.atom);
  }
  RunRequest request;
  request.agent_file = options.agent;
  if (!options.scenario.empty()) request.scenario = options.scenario;
  request.seed = options.seed;
  request.overrides = ParseSettings(options.settings);
  FinishedRun run;
  std::optional<schedule::Agent> agent = PrepareAgent(request, registry, symbols, run);
  if (!agent) {
    fmt::print(stderr, "{}", run.errors);
    return run.exit_code;
  }
  Interview interview(options, *agent, std::move(why_not));
  schedule::LockstepOptions lockstep_options;
  lockstep_options.observers.push_back(&interview);
  lockstep_options.max_ticks = options.tick + 1;
  schedule::Lockstep lockstep(std::move(*agent), lockstep_options);
  lockstep.Run();
  fmt::print("{}", interview.text());
  if (!interview.text().empty()) return kDone;
  fmt::print(stderr, "no layer {}decides at tick {}\n",
             options.layer.empty() ? "" : "'" + options.layer + "' ", options.tick);
  return kGoalNotReached;
}

}  // namespace

void AddExplain(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("explain", "Say why the layers decided as they did");
  auto options = std::make_shared<ExplainOptions>();
  command->add_option("AGENT", options->agent, "Agent file (XML)")->required();
  command->add_option("--tick", options->tick, "The tick to explain (default 0)");
  command->add_option("--layer", options->layer, "Only this layer");
  command->add_option("--why-not", options->why_not,
                      "An atom, with variables perhaps: why no layer concludes it, as 'fwd(X)'");
  command->add_option("--seed", options->seed, "Of everything random in the world (default 1)");
  command->add_option("--scenario", options->scenario,
                      "Fragment file whose overrides and events come on top");
  command->add_option("--set", options->settings, "PART.NAME=VALUE, as in world.people=4")
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "A JSON object a line");
  command->footer(
      "The run is made anew up to the tick, and each reasoner asked about its decision: how it\n"
      "came to each conclusion, and for each default why it was made, or which fact of which "
      "latch\n"
      "retracted it. Not all reasoners keep reasons for defaults; circumscription does.\n\n"
      "Examples:\n"
      "  latchwork explain examples/office/scenario1.xml --tick 40 --layer avoid\n"
      "  latchwork explain examples/office/scenario1.xml --scenario "
      "examples/office/circumscription.xml\n"
      "      --tick 40 --layer avoid --why-not 'halt_robot'\n");
  command->callback([options, &context] { context.exit_code = Explain(*options, context); });
}

}  // namespace latchwork::app

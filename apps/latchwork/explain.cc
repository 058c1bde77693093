// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
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
    layers_ = agent.description.layers;
    for (const auto& layer : agent.layers) reasoners_.push_back(layer.reasoner);
  }

  bool OnTick(const schedule::TickRecord& record) override {
    if (record.tick < options_.tick) return true;
    for (const schedule::DecisionRecord& each : record.decisions) {
      if (options_.layer.empty() || layers_[each.layer].name == options_.layer) Ask(each);
    }
    return false;
  }

  const std::string& text() const { return text_; }

 private:
  void Ask(const schedule::DecisionRecord& record) {
    const sdk::Decision& decision = *record.decision;
    sdk::Reasoner& reasoner = *reasoners_[record.layer];
    Say(fmt::format("layer {}: {}{}{}\n", layers_[record.layer].name, sdk::Name(decision.status),
                    decision.message.empty() ? "" : ", ", decision.message));
    lacks_reasons_ = false;
    for (std::size_t i = 0; i < decision.conclusions.size(); ++i) {
      sdk::Explanation explanation{logic::ToString(decision.conclusions[i].fact), true, {}, {}};
      explanation.derivation = reasoner.Explain(i);
      const bool is_bare = explanation.derivation.steps.empty();
      lacks_reasons_ = lacks_reasons_ || is_bare;
      if (is_bare && !options_.json) {
        Say(fmt::format("conclusion: {}, whose derivation is not kept\n", explanation.subject));
      } else {
        Say(explanation, record.layer, "conclusion");
      }
    }
    for (std::size_t i = 0; i < decision.assumptions.size(); ++i) {
      SayWhy(decision.assumptions[i], reasoner.ExplainAssumption(i), record.layer);
    }
    SayAlike();
    if (why_not_) {
      const auto explanation = reasoner.WhyNot(*why_not_);
      lacks_reasons_ = lacks_reasons_ || !explanation;
      if (explanation) Say(*explanation, record.layer, "why not");
    }
    const bool is_decided =
        decision.status != sdk::Status::kInconsistent && decision.status != sdk::Status::kFailed;
    if (lacks_reasons_ && is_decided) SayWhoKeepsReasons(layers_[record.layer]);
  }

  void SayWhy(const sdk::Assumption& assumption, const std::optional<sdk::Explanation>& explanation,
              std::size_t layer) {
    const std::string what = fmt::format("assumption, {}", sdk::Name(assumption.state));
    if (explanation && !options_.json && IsBare(*explanation)) {
      return Gather(what, assumption.atom);
    }
    if (explanation) return Say(*explanation, layer, what);
    lacks_reasons_ = true;
    const std::string atom = logic::ToString(assumption.atom);
    const bool holds = assumption.state == sdk::Assumption::State::kRetracted;
    if (options_.json) return Say(sdk::Explanation{atom, holds, {}, {}}, layer, what);
    Say(fmt::format("{}: {} was {}proved, for reasons that are not kept\n", what, atom,
                    holds ? "" : "not "));
  }

  /// Nothing comes near to concluding it: of such defaults there may be hundreds.
  static bool IsBare(const sdk::Explanation& explanation) {
    return !explanation.holds && explanation.misses.empty() && explanation.derivation.steps.empty();
  }

  void Gather(const std::string& what, const logic::Fact& atom) {
    const std::string_view predicate = atom.predicate().name();
    auto group = std::ranges::find_if(alike_, [&](const Alike& each) {
      return each.what == what && each.predicate == predicate;
    });
    if (group == alike_.end()) {
      group = alike_.insert(alike_.end(), {what, std::string(predicate), 0, ""});
    }
    if (group->count < kShown) {
      group->shown += (group->count == 0 ? "" : ", ") + logic::ToString(atom);
    }
    ++group->count;
  }

  void SayAlike() {
    for (const Alike& group : alike_) {
      if (group.count <= kShown) {
        Say(fmt::format("{}: nothing concludes {}, nor could\n", group.what, group.shown));
      } else {
        Say(
            fmt::format("{}: nothing concludes any of {} instances of {}, nor could: {} and so on "
                        "(--json lists all)\n",
                        group.what, group.count, group.predicate, group.shown));
      }
    }
    alike_.clear();
  }

  void SayWhoKeepsReasons(const config::LayerDescription& layer) {
    const std::string& plugin = layer.reasoner.plugin;
    if (plugin == "pttp" || plugin == "circumscription") {
      return Say(fmt::format(
          "layer {}: not all reasons were found within the budget of a decision\n", layer.name));
    }
    std::string remedy = "pttp and circumscription do, where a layer has a theory for them";
    if (layer.language == "tptp") {
      remedy = R"(for the same theory <reasoner plugin="circumscription"/> or "pttp" does)";
    } else if (layer.language == "icarus") {
      remedy = fmt::format(
          "'latchwork icarus record --layer {}' writes its cycles down for 'latchwork icarus "
          "repl', "
          "which answers why and why-not",
          layer.name);
    }
    Say(fmt::format("layer {}: reasoner {} does not keep all reasons; {}\n", layer.name, plugin,
                    remedy));
  }

  void Say(const std::string& line) {
    if (!options_.json) text_ += line;
  }
  void Say(const sdk::Explanation& explanation, std::size_t layer, const std::string& what) {
    if (options_.json) {
      text_ += fmt::format("{{\"layer\":\"{}\",\"what\":\"{}\",\"explanation\":{}}}\n",
                           layers_[layer].name, what, ToJson(explanation));
    } else {
      text_ += fmt::format("{}: {}", what, ToText(explanation));
    }
  }

  static constexpr std::size_t kShown = 3;
  /// Defaults of one predicate and state with nothing to be said of any of them.
  struct Alike {
    std::string what;
    std::string predicate;
    std::size_t count;
    std::string shown;  ///< The first of them.
  };

  const ExplainOptions& options_;
  std::optional<logic::Atom> why_not_;
  std::vector<config::LayerDescription> layers_;
  std::vector<std::shared_ptr<sdk::Reasoner>> reasoners_;
  std::vector<Alike> alike_;
  std::string text_;
  bool lacks_reasons_ = false;  ///< Of the decision at hand.
};

bool HasLayer(const schedule::Agent& agent, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& layer : agent.description.layers) names.push_back(layer.name);
  if (name.empty() || std::ranges::find(names, name) != names.end()) return true;
  fmt::print(stderr, "latchwork: --layer: there is no layer '{}'; {}'s are {}\n", name,
             agent.description.name, fmt::join(names, ", "));
  return false;
}

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
  auto [agent, diagnostics, exit_code] = PrepareAgent(request, registry, symbols);
  if (!agent) {
    fmt::print(stderr, "{}", logic::Format(diagnostics));
    return exit_code;
  }
  if (!HasLayer(*agent, options.layer)) return kUsage;
  Interview interview(options, *agent, std::move(why_not));
  schedule::LockstepOptions lockstep_options;
  lockstep_options.observers.push_back(&interview);
  lockstep_options.max_ticks = options.tick + 1;
  schedule::Lockstep lockstep(std::move(*agent), lockstep_options);
  const schedule::RunResult result = lockstep.Run();
  fmt::print("{}", interview.text());
  if (!interview.text().empty()) return kDone;
  if (result.ticks < options.tick) {
    fmt::print(stderr, "there is no tick {}: the run ends after {} ticks ({})\n", options.tick,
               result.ticks, result.message);
  } else {
    fmt::print(stderr, "no layer {}decides at tick {}\n",
               options.layer.empty() ? "" : "'" + options.layer + "' ", options.tick);
  }
  return kGoalNotReached;
}

}  // namespace

void AddExplain(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("explain", "Say why the layers decided as they did");
  auto options = std::make_shared<ExplainOptions>();
  command->add_option("AGENT", options->agent, "Agent file (XML)")->required();
  command->add_option("--tick", options->tick, "The tick to explain (default 0)")
      ->check(WholeNumber());
  command->add_option("--layer", options->layer, "Only this layer");
  command->add_option("--why-not", options->why_not,
                      "An atom, with variables perhaps: why no layer concludes it, as 'fwd(X)'");
  command->add_option("--seed", options->seed, "Of everything random in the world (default 1)")
      ->check(WholeNumber());
  command->add_option("--scenario", options->scenario,
                      "Fragment file whose overrides and events come on top");
  command->add_option("--set", options->settings, "PART.NAME=VALUE, as in world.people=4")
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "A JSON object a line");
  command->footer(
      "The run is made anew up to the tick, and each reasoner asked about its decision: how it\n"
      "came to each conclusion, and for each default why it was made, or which fact of which "
      "latch\n"
      "retracted it. Not all reasoners keep reasons: pttp and circumscription do, and Icarus for "
      "what "
      "it\n"
      "concludes.\n\n"
      "Examples:\n"
      "  latchwork explain examples/office/scenario1.xml --tick 40 --layer avoid\n"
      "  latchwork explain examples/office/scenario1.xml --scenario "
      "examples/office/circumscription.xml\n"
      "      --tick 40 --layer avoid --why-not 'halt_robot'\n");
  command->callback([options, &context] { context.exit_code = Explain(*options, context); });
}

}  // namespace latchwork::app

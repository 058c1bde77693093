// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/latchwork/agent_theory.h"
#include "apps/latchwork/command.h"
#include "apps/latchwork/semantics_findings.h"
#include "apps/latchwork/semantics_problem.h"
#include "apps/latchwork/semantics_report.h"

namespace latchwork::app {
namespace {

namespace circ = latchwork::circumscription;

struct SemanticsSettings {
  std::string file;
  std::string transfer;            ///< Empty: all.
  std::vector<std::string> facts;  ///< "LAYER: atom", of an agent.
  circ::ProcedureOptions options;
  bool json = false;
};

std::vector<circ::Transfer> TransfersOf(const SemanticsSettings& settings) {
  if (const auto transfer = circ::FindTransfer(settings.transfer)) return {*transfer};
  return {std::begin(circ::kTransfers), std::end(circ::kTransfers)};
}

SemanticsProblem ReadProblem(const SemanticsSettings& settings, const Context& context) {
  if (std::filesystem::path(settings.file).extension() == ".xml") {
    return ReadAgentProblem(settings.file, settings.facts, context);
  }
  SemanticsProblem problem = ReadLayProblem(settings.file);
  if (settings.facts.empty()) return problem;
  problem.diagnostics.push_back(
      {{"--fact", 0, 0}, "only agents are told facts", "a .lay file has F lines", ""});
  return problem;
}

int RunSemantics(const SemanticsSettings& settings, const Context& context) {
  const SemanticsProblem problem = ReadProblem(settings, context);
  if (!problem.diagnostics.empty()) {
    fmt::print(stderr, "{}", logic::Format(problem.diagnostics));
    return problem.plugin_failure ? kPluginFailure : kInvalidInput;
  }
  const SemanticsFindings findings = Evaluate(problem, TransfersOf(settings), settings.options);
  if (settings.json) {
    constexpr auto kReplaceBadText = nlohmann::ordered_json::error_handler_t::replace;
    fmt::print("{}\n", ToJson(problem, findings).dump(2, ' ', false, kReplaceBadText));
  } else {
    // The answers come last, where a program that reads them meets nothing after them.
    fmt::print("{}\n{}", Describe(problem, findings), AnswerLines(problem, findings));
  }
  if (findings.difference) return kDiverged;
  const bool has_model = findings.conditions.has_model == circ::Verdict::kYes;
  return has_model && findings.AllDecided() ? kDone : kGoalNotReached;
}

constexpr const char* kFooter =
    "What do layers mean together? Definition 1 says it without a procedure: a layered model is,\n"
    "in every layer, a minimal model of the layer and of what the goals above it hand down, where\n"
    "a bridge from a goal to a latch is given up (ab) only if it must be. The procedure goes from\n"
    "layer to layer instead, and hands down, by --transfer\n"
    "  single    the goals that are proved: what is undecided counts as silent, so that a default\n"
    "            below may be assumed that some layered model does not allow\n"
    "  open      besides, each undecided goal under a premise that may hold or not: never wrong,\n"
    "            but blind to what undecided goals have in common\n"
    "  refined   every state of all goals, one after the other: exact, and slow with many\n\n"
    "This command says whether the conditions hold under which the two agree, compares them on\n"
    "the queries, and cuts the first difference down to a smallest theory that shows it. Last\n"
    "come the answers, 's|o|r|= ID yes|no|unknown': s, o and r by transfer, = by Definition 1;\n"
    "with --transfer only 'ID yes|no|unknown' of that one.\n\n"
    "Of an agent, each layer must be a finite theory: a TPTP body without functions, arithmetic\n"
    "and attachments. The constants that occur in a layer, or are handed down to it, are all "
    "there\n"
    "is. Sensors say what --fact tells, and all goals of the lowest layer are asked.\n\n"
    "A .lay file, one statement a line:\n"
    "  p lay 2 6        2 layers, atoms 1 to 6\n"
    "  L 1              layer 1, the lowest; a name may follow\n"
    "  n 1 object       a name for people\n"
    "  P 1 1 2 0        atoms of this layer, minimized at priority 1, the first\n"
    "  Z 3 0            atoms that vary; Q: fixed\n"
    "  -1 2 0           a clause: not 1, or 2\n"
    "  2 3 0\n"
    "  B 5 1            a bridge: what is 5 above is 1 here\n"
    "  L 2\n"
    "  P 1 4 5 6 0\n"
    "  -4 5 6 0\n"
    "  F 4 0            facts\n"
    "  ? go c 3 -2 0    does every layered model satisfy (3 or not 2)? Atoms of layer 1\n\n"
    "Exit codes: 0 all decided, and the procedure is right on every query; 1 a budget ran out, or\n"
    "there is no layered model; 2 wrong usage; 3 invalid input, or a layer that is no\n"
    "finite theory; 4 a plugin cannot be loaded; 6 the procedure and Definition 1 differ.";

}  // namespace

void AddSemantics(CLI::App& app, Context& context) {
  const auto settings = std::make_shared<SemanticsSettings>();
  settings->options.engine.conflicts = 2'000'000;
  CLI::App* command = app.add_subcommand(
      "semantics", "Compare what layers conclude with what the layered theory means");
  command
      ->add_option("FILE", settings->file,
                   "Agent (.xml), or a layered theory (.lay; '-' reads standard input)")
      ->required();
  command->add_option("--transfer", settings->transfer, "Only this one: single, open or refined")
      ->check(CLI::IsMember({"single", "open", "refined"}));
  command
      ->add_option("--fact", settings->facts,
                   "'LAYER: ATOM', what a sensor of an agent's layer says; may be repeated")
      ->allow_extra_args(false);
  command
      ->add_option("--conflicts", settings->options.engine.conflicts,
                   "Conflicts that one SAT call may take")
      ->check(CLI::Range(1, 2'000'000'000))
      ->capture_default_str();
  command
      ->add_option("--calls", settings->options.engine.calls, "SAT calls that one query may take")
      ->check(CLI::Range(1, 2'000'000'000))
      ->capture_default_str();
  command
      ->add_option("--states", settings->options.max_states,
                   "Goal states of a layer that 'refined' goes through")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command->add_flag("--json", settings->json, "Print all of it as JSON");
  command->footer(kFooter);
  command->callback([settings, &context] { context.exit_code = RunSemantics(*settings, context); });
}

}  // namespace latchwork::app

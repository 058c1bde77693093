// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/latchwork/command.h"
#include "apps/latchwork/icarus_command.h"
#include "reasoners/circumscription/engine/engine.h"
#include "reasoners/circumscription/engine/minimal_core.h"
#include "reasoners/circumscription/formats/circ_file.h"

namespace latchwork::app {
namespace {

namespace circ = latchwork::circumscription;

struct EntailSettings {
  std::string file;
  int conflicts = 2'000'000;
  std::size_t calls = 1'000'000;
  bool basis = false;
};

/// What is asked of which theory.
struct Problem {
  circ::GroundTheory theory;
  std::vector<circ::Literal> latches;
  std::vector<circ::Query> queries;
};

void ReportInconsistency(const Problem& problem, const EntailSettings& settings) {
  fmt::print(stderr,
             "{}: the theory has no model: every cautious query is answered yes, every "
             "brave one no\n",
             settings.file);
  const auto core = circ::MinimalCore(problem.theory, problem.latches, settings.conflicts);
  if (!core) return;
  fmt::print(stderr, "  these contradict each other, and without any one of them no longer:\n");
  for (const circ::Literal latch : core->latches) {
    fmt::print(stderr, "    fact    {}\n", circ::ToString(problem.theory, latch));
  }
  for (const std::size_t index : core->clauses) {
    fmt::print(stderr, "    clause  {}\n",
               circ::ToString(problem.theory, problem.theory.clauses[index]));
  }
}

/// Whether all queries were decided on a consistent theory.
bool Answer(const Problem& problem, const EntailSettings& settings) {
  circ::EngineOptions options;
  options.conflicts = settings.conflicts;
  options.calls = settings.calls;
  circ::Engine engine(problem.theory, options);
  engine.SetLatches(problem.latches);
  bool decided = true;
  for (const circ::Query& query : problem.queries) {
    const circ::Answer answer =
        query.brave ? engine.HoldsSomewhere(query.literals) : engine.EntailsAlways(query.literals);
    decided = decided && answer.verdict != circ::Verdict::kUnknown;
    fmt::print("{} {}{}{}\n", query.id, circ::Name(answer.verdict), settings.basis ? "  % " : "",
               settings.basis ? circ::Name(answer.basis) : "");
  }
  std::fflush(stdout);
  const bool inconsistent = engine.IsInconsistent().verdict == circ::Verdict::kYes;
  if (inconsistent) ReportInconsistency(problem, settings);
  return decided && !inconsistent;
}

int RunEntail(const EntailSettings& settings) {
  const std::optional<std::string> text = ReadProgramText(settings.file);
  if (!text) return kInvalidInput;
  circ::CircFile file = circ::ReadCirc(*text, settings.file);
  if (!file.diagnostics.empty()) {
    fmt::print(stderr, "{}", logic::Format(file.diagnostics));
    return kInvalidInput;
  }
  Problem problem{std::move(file.theory), {}, std::move(file.queries)};
  problem.latches = circ::MoveFacts(file.facts, problem.theory);
  return Answer(problem, settings) ? kDone : kGoalNotReached;
}

}  // namespace

void AddEntail(CLI::App& app, Context& context) {
  const auto settings = std::make_shared<EntailSettings>();
  CLI::App* command =
      app.add_subcommand("entail", "Say what follows from a theory by circumscription");
  command->add_option("FILE", settings->file, "Theory in .circ form; '-' reads standard input")
      ->required();
  command->add_option("--conflicts", settings->conflicts, "Conflicts that one SAT call may take")
      ->check(CLI::Range(1, 2'000'000'000))
      ->capture_default_str();
  command->add_option("--calls", settings->calls, "SAT calls that one query may take")
      ->check(CLI::Range(1, 2'000'000'000))
      ->capture_default_str();
  command->add_flag("--basis", settings->basis, "Print what each answer rests on");
  command->footer(
      "Prints a line 'ID yes|no|unknown' for each query. Cautious queries ask whether every\n"
      "minimal model satisfies a disjunction, brave ones whether some satisfies a conjunction.\n\n"
      "A .circ file, one statement a line:\n"
      "  p circ 4 2       atoms 1 to 4, 2 clauses\n"
      "  n 1 abnormal     a name for people\n"
      "  P 1 1 0          atoms minimized at priority 1, the first; all at 1: parallel\n"
      "  Z 2 3 0          atoms that vary\n"
      "  Q 4 0            atoms that are fixed\n"
      "  -4 1 2 0         a clause: not 4, or 1, or 2\n"
      "  -2 3 0\n"
      "  F 4 0            facts\n"
      "  ? fly c 2 -1 0   does every minimal model satisfy (2 or not 1)?\n"
      "  ? odd b 1 3 0    does some minimal model satisfy (1 and 3)?\n\n"
      "Exit codes: 0 every query decided; 1 some are not, or the theory has no model (the "
      "smallest\n"
      "part that contradicts itself is named); 2 wrong usage; 3 invalid input.");
  command->callback([settings, &context] { context.exit_code = RunEntail(*settings); });
}

}  // namespace latchwork::app

// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "apps/latchwork/command.h"
#include "apps/latchwork/entail_problem.h"
#include "reasoners/circumscription/engine/engine.h"
#include "reasoners/circumscription/engine/minimal_core.h"
#include "reasoners/circumscription/policies/policy.h"

namespace latchwork::app {
namespace {

namespace circ = latchwork::circumscription;

struct EntailSettings {
  EntailInput input;
  int conflicts = 2'000'000;
  std::size_t calls = 1'000'000;
  std::string policy = "ecwa";
  bool basis = false;
};

void ReportInconsistency(const EntailProblem& problem, const EntailSettings& settings) {
  fmt::print(stderr,
             "{}: the theory has no model: every cautious query is answered yes, every "
             "brave one no\n",
             settings.input.input.file);
  const auto core = circ::MinimalCore(problem.theory, problem.latches, settings.conflicts);
  if (!core) {
    fmt::print(stderr, "  the theory has one: what the policy assumes contradicts itself\n");
    return;
  }
  fmt::print(stderr, "  these contradict each other, and without any one of them no longer:\n");
  for (const circ::Literal latch : core->latches) {
    fmt::print(stderr, "    fact    {}\n", circ::ToString(problem.theory, latch));
  }
  for (const std::size_t index : core->clauses) {
    fmt::print(stderr, "    clause  {}\n",
               circ::ToString(problem.theory, problem.theory.clauses[index]));
  }
}

/// Whether all queries were decided on a consistent theory. `world`: an Engine or a ClosedWorld.
template <typename World>
bool AnswerFrom(World& world, const EntailProblem& problem, const EntailSettings& settings) {
  bool decided = true;
  for (const circ::Query& query : problem.queries) {
    const circ::Answer answer =
        query.brave ? world.HoldsSomewhere(query.literals) : world.EntailsAlways(query.literals);
    decided = decided && answer.verdict != circ::Verdict::kUnknown;
    fmt::print("{} {}{}{}\n", query.id, circ::Name(answer.verdict), settings.basis ? "  % " : "",
               settings.basis ? circ::Name(answer.basis) : "");
  }
  std::fflush(stdout);
  const bool inconsistent = world.IsInconsistent().verdict == circ::Verdict::kYes;
  if (inconsistent) ReportInconsistency(problem, settings);
  return decided && !inconsistent;
}

bool Answer(const EntailProblem& problem, const EntailSettings& settings) {
  circ::EngineOptions options;
  options.conflicts = settings.conflicts;
  options.calls = settings.calls;
  const circ::Policy policy = *circ::FindPolicy(settings.policy);
  if (policy != circ::Policy::kEcwa) {
    circ::ClosedWorld world(problem.theory, problem.latches, policy, options);
    if (!world.complete()) fmt::print(stderr, "the budget did not suffice to close all atoms\n");
    return AnswerFrom(world, problem, settings) && world.complete();
  }
  circ::Engine engine(problem.theory, options);
  engine.SetLatches(problem.latches);
  return AnswerFrom(engine, problem, settings);
}

int RunEntail(const EntailSettings& settings) {
  const EntailProblem problem = ReadEntailProblem(settings.input);
  if (!problem.diagnostics.empty()) {
    fmt::print(stderr, "{}", logic::Format(problem.diagnostics));
    return kInvalidInput;
  }
  return Answer(problem, settings) ? kDone : kGoalNotReached;
}

constexpr const char* kFooter =
    "Prints a line 'ID yes|no|unknown' for each query.\n\n"
    "TPTP problems without functions: conjectures and --query formulas are asked. The constants\n"
    "that occur, in axioms or queries, are taken to be all different, and all there is; where "
    "there\n"
    "are none, one thing without a name is. A constant that only one query names exists for the\n"
    "others, too: with p(a) alone, '![X]: p(X)' holds, and no longer when '~p(b)' is asked with "
    "it.\n"
    "Ask such queries in runs of their own. Minimized predicates hold only where they must; those "
    "that no option names vary. For example, birds.p says\n"
    "  fof(birds, axiom, ![X]: ((bird(X) & ~abnormal(X)) => flies(X))).\n"
    "  fof(tweety, axiom, bird(tweety)).\n"
    "and\n"
    "  latchwork entail birds.p --minimize abnormal/1 --query 'flies(tweety)'\n"
    "prints 'q1 yes'. With --minimize twice, what comes first is minimized first.\n\n"
    "Ground theories, as .circ files, one statement a line:\n"
    "  p circ 4 2       atoms 1 to 4, 2 clauses\n"
    "  n 1 abnormal     a name for people\n"
    "  P 1 1 0          atoms minimized at priority 1, the first; all at 1: parallel\n"
    "  Z 2 3 0          atoms that vary\n"
    "  Q 4 0            atoms that are fixed\n"
    "  -4 1 2 0         a clause: not 4, or 1, or 2\n"
    "  -2 3 0\n"
    "  F 4 0            facts\n"
    "  ? fly c 2 -1 0   cautious: does every minimal model satisfy (2 or not 1)?\n"
    "  ? odd b 1 3 0    brave: does some minimal model satisfy (1 and 3)?\n\n"
    "Exit codes: 0 every query decided; 1 some are not, or the theory has no model (a smallest\n"
    "part that contradicts itself is named); 2 wrong usage; 3 invalid input.";

void AddTheoryOptions(CLI::App& command, EntailInput& input) {
  command
      .add_option("--minimize", input.minimize,
                  "Predicates NAME/ARITY,... to minimize; may be repeated, first things first")
      ->allow_extra_args(false);
  command.add_option("--vary", input.vary, "Predicates that may vary (the default)")
      ->allow_extra_args(false);
  command.add_option("--fix", input.fix, "Predicates that are fixed")->allow_extra_args(false);
  command.add_option("--query", input.queries, "A TPTP formula to ask for; may be repeated")
      ->allow_extra_args(false);
  command.add_flag("--brave", input.brave,
                   "Ask whether queries hold in some minimal model, not in all");
  AddTptpFolder(command, input.input);
}

}  // namespace

void AddEntail(CLI::App& app, Context& context) {
  const auto settings = std::make_shared<EntailSettings>();
  CLI::App* command =
      app.add_subcommand("entail", "Say what follows from a theory by circumscription");
  command
      ->add_option("FILE", settings->input.input.file,
                   "TPTP problem or .circ file; '-' reads standard input")
      ->required();
  AddTheoryOptions(*command, settings->input);
  command->add_option("--conflicts", settings->conflicts, "Conflicts that one SAT call may take")
      ->check(CLI::Range(1, 2'000'000'000))
      ->capture_default_str();
  command->add_option("--calls", settings->calls, "SAT calls that one query may take")
      ->check(CLI::Range(1, 2'000'000'000))
      ->capture_default_str();
  command
      ->add_option("--policy", settings->policy,
                   "cwa, gcwa, ccwa, egcwa, or ecwa, which is circumscription")
      ->check(CLI::IsMember({"cwa", "gcwa", "ccwa", "egcwa", "ecwa"}))
      ->capture_default_str();
  command->add_flag("--basis", settings->basis, "Print what each answer rests on");
  command->footer(kFooter);
  command->callback([settings, &context] { context.exit_code = RunEntail(*settings); });
}

}  // namespace latchwork::app

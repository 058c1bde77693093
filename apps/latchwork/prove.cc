// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/latchwork/command.h"
#include "apps/latchwork/parameter_options.h"
#include "apps/latchwork/prove_limits.h"
#include "apps/latchwork/tptp_input.h"
#include "reasoners/pttp/options.h"
#include "reasoners/pttp/proofs/failure_explanation.h"
#include "reasoners/pttp/strategies/prover.h"
#include "reasoners/pttp/strategies/schedule.h"

namespace latchwork::app {
namespace {

/// Enough for what may be read at all: memory is bounded by --memory.
constexpr std::size_t kMostTokens = 200'000'000;

struct ProveSettings {
  TptpInput input{"", "", kMostTokens};
  std::vector<sdk::Parameters::Given> options;  ///< Of pttp::ProblemOptions().
  bool proof = false;
  bool answers = false;
  bool statistics = false;
  bool json = false;
  bool why = false;
};

/// What an attempt came to.
struct Outcome {
  std::string_view status;
  bool proved = false;
  pttp::ProverResult result;
};

/// The wall clock only guards against a process that gets no CPU time.
std::chrono::steady_clock::time_point Guard(double cpu_seconds) {
  const std::chrono::duration<double> wall(10 * cpu_seconds + 60);
  return std::chrono::steady_clock::now() +
         std::chrono::duration_cast<std::chrono::steady_clock::duration>(wall);
}

void Print(const nlohmann::ordered_json& report) {
  fmt::print("{}\n", report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

int RefuseInput(const ProveSettings& settings, const logic::TptpFile& input, ProveLimits& limits) {
  limits.Release();
  const std::string& file = settings.input.file;
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  const bool exists =
      file == "-" ? std::ferror(stdin) == 0
                  : (std::filesystem::exists(status) && !std::filesystem::is_directory(status));
  const std::string_view szs = exists ? "SyntaxError" : "InputError";
  const std::string report = Format(input.diagnostics);
  fmt::print(stderr, "{}", report);
  if (settings.json) {
    Print({{"file", file}, {"status", szs}, {"message", report}});
  } else {
    fmt::print("% SZS status {} for {}\n", szs, file);
  }
  return kInvalidInput;
}

pttp::ProverOptions OptionsFor(const ProveSettings& settings, const sdk::Parameters& values,
                               const logic::TptpFile& input) {
  pttp::ProverOptions options = pttp::OptionsFrom(values);
  options.budget.deadline = Guard(options.cpu_seconds);
  options.budget.cancelled = &ProveLimits::cancelled();
  options.answers = settings.answers || input.asks;
  options.texts = input.texts;
  options.explain = settings.why;
  options.proof = settings.proof || settings.answers || input.asks || settings.why;
  return options;
}

Outcome Attempt(const ProveSettings& settings, const logic::TptpFile& input,
                const pttp::ProverOptions& options, logic::SymbolTable& symbols) {
  Outcome outcome;
  try {
    outcome.result = pttp::Prove(input.formulas, symbols, settings.input.file, options);
  } catch (const std::length_error& error) {
    outcome.result.status = pttp::Szs::kResourceOut;
    outcome.result.message = error.what();
  } catch (const std::bad_alloc&) {
    outcome.result.status = pttp::Szs::kResourceOut;
  }
  const pttp::Szs status = outcome.result.status;
  outcome.status = Name(status);
  outcome.proved = status == pttp::Szs::kTheorem || status == pttp::Szs::kUnsatisfiable;
  if (status == pttp::Szs::kTheorem && options.proof && !outcome.result.uses_conjecture) {
    outcome.status = "ContradictoryAxioms";
  }
  if (status == pttp::Szs::kTimeout && !ProveLimits::reason().empty()) {
    outcome.status = ProveLimits::reason();
  }
  return outcome;
}

void PrintAnswers(const ProveSettings& settings, const pttp::ProverResult& result) {
  if (result.answers.empty()) return;
  std::vector<std::string> tuples;
  for (const auto& tuple : result.answers) {
    tuples.push_back(fmt::format("[{}]", fmt::join(tuple, ",")));
  }
  const std::string one = fmt::format("{}", fmt::join(tuples, "|"));
  fmt::print("% SZS answers Tuple [{}|_] for {}\n", tuples.size() == 1 ? one : "(" + one + ")",
             settings.input.file);
}

void PrintText(const ProveSettings& settings, bool answers, const Outcome& outcome) {
  const pttp::ProverResult& result = outcome.result;
  const std::string& file = settings.input.file;
  fmt::print("% SZS status {} for {}\n", outcome.status, file);
  if (!result.message.empty() && !outcome.proved) fmt::print("% {}\n", result.message);
  if (answers && outcome.proved) PrintAnswers(settings, result);
  if (settings.proof && outcome.proved) {
    fmt::print("% SZS output start Proof for {}\n", file);
    for (const std::string& line : result.proof) fmt::print("{}\n", line);
    fmt::print("% SZS output end Proof for {}\n", file);
  }
  for (const pttp::ExplanationLine& line : result.explanation) {
    fmt::print("% {:{}}{}\n", "", 2 * line.depth, line.text);
  }
  if (settings.statistics) {
    fmt::print("% strategy {}\n% clauses {}\n% inferences {}\n% depth {}\n", result.strategy,
               result.clauses, result.statistics.inferences, result.statistics.depth);
  }
}

/// Why it gave up.
std::string MessageOf(const Outcome& outcome) {
  if (outcome.proved || !outcome.result.message.empty()) return outcome.result.message;
  if (outcome.status == "Timeout") return "the time that --time allows is over";
  if (outcome.status == "ResourceOut") return "a budget or the memory that --memory allows ran out";
  if (outcome.status == "User") return "it was interrupted";
  if (outcome.status == "Forced") return "it was told to end";
  return "";
}

void PrintJson(const ProveSettings& settings, bool answers, const Outcome& outcome) {
  const pttp::ProverResult& result = outcome.result;
  nlohmann::ordered_json report{
      {"file", settings.input.file},     {"status", outcome.status},
      {"strategy", result.strategy},     {"message", MessageOf(outcome)},
      {"clauses", result.clauses},       {"inferences", result.statistics.inferences},
      {"depth", result.statistics.depth}};
  if (answers && outcome.proved) report["answers"] = result.answers;
  if (settings.proof && outcome.proved) report["proof"] = result.proof;
  if (settings.why) {
    report["why"] = nlohmann::ordered_json::array();
    for (const pttp::ExplanationLine& line : result.explanation) {
      report["why"].push_back({{"depth", line.depth}, {"text", line.text}});
    }
  }
  Print(report);
}

/// After the limits have been lifted: it is short, and a search that ran out of time is the one to
/// be explained.
void AddFailure(const pttp::ProverOptions& options, logic::SymbolTable& symbols, Outcome& outcome) {
  if (!options.explain || outcome.proved) return;
  try {
    outcome.result.explanation = pttp::ExplainFailure(outcome.result, options, symbols);
  } catch (const std::bad_alloc&) {
    outcome.result.explanation = {{0, "There is not enough memory to say why."}};
  }
}

int RunProve(const ProveSettings& settings) {
  const sdk::Parameters values = Values(pttp::ProblemOptions(), settings.options);
  ProveLimits limits(values.Real("time"), static_cast<std::size_t>(values.Integer("memory")),
                     settings.input.file, settings.json);
  logic::SymbolTable symbols;
  const Keep keep = settings.proof ? Keep::kTexts : Keep::kNothing;
  const logic::TptpFile input = Read(settings.input, symbols, keep);
  if (!input.diagnostics.empty()) return RefuseInput(settings, input, limits);
  const pttp::ProverOptions options = OptionsFor(settings, values, input);
  Outcome outcome = Attempt(settings, input, options, symbols);
  limits.Release();
  AddFailure(options, symbols, outcome);
  const bool answers = settings.answers || input.asks;
  settings.json ? PrintJson(settings, answers, outcome) : PrintText(settings, answers, outcome);
  std::fflush(stdout);
  return outcome.proved ? kDone : kGoalNotReached;
}

std::string StrategyHelp() {
  std::string help = "Strategies, [C] those that are complete:\n";
  for (const pttp::NamedStrategy& strategy : pttp::Strategies()) {
    help += fmt::format("  {:<18}{:<4}{}\n", strategy.name, strategy.complete ? "[C]" : "",
                        strategy.help);
  }
  return help;
}

}  // namespace

void AddProve(CLI::App& app, Context& context) {
  auto settings = std::make_shared<ProveSettings>();
  CLI::App* command =
      app.add_subcommand("prove", "Prove the conjecture of a TPTP file, or refute its clauses");
  command->add_option("FILE", settings->input.file, "TPTP file; '-' reads standard input")
      ->required();
  AddTptpFolder(*command, settings->input);
  AddParameterOptions(*command, pttp::ProblemOptions(), settings->options, {{"time", "cpu-limit"}});
  command->add_flag("--proof,!--no-proof", settings->proof, "Print the proof in TSTP syntax");
  command->add_flag(
      "--why", settings->why,
      "Explain the proof; without one, say what ended the search and what is missing");
  command->add_flag("--answers", settings->answers,
                    "Print the values of the conjecture's variables; always done for a question");
  command->add_flag("--stats", settings->statistics, "Print what the search cost");
  command->add_flag("--json", settings->json, "Print JSON instead of SZS lines");
  command->footer(
      StrategyHelp() +
      "\nOne SZS status line comes out, whatever happens.\n"
      "Exit codes: 0 Theorem, Unsatisfiable or ContradictoryAxioms; 1 CounterSatisfiable,\n"
      "Satisfiable, or not decided (Timeout, ResourceOut, GaveUp, User, Forced);\n"
      "2 wrong usage; 3 SyntaxError or InputError.");
  command->callback([settings, &context] { context.exit_code = RunProve(*settings); });
}

}  // namespace latchwork::app

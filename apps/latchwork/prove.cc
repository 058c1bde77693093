// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <limits>
#include <memory>
#include <string>

#include "apps/latchwork/command.h"
#include "latchwork/logic/tptp.h"
#include "reasoners/pttp/prover.h"

namespace latchwork::app {
namespace {

struct ProveSettings {
  std::string file;
  double seconds = 10.0;
  std::uint64_t inferences = std::numeric_limits<std::uint64_t>::max();
  std::uint32_t depth = 1'000'000;
  bool proof = false;
  bool answers = false;
  bool statistics = false;
};

logic::TptpFile Read(const ProveSettings& settings, logic::SymbolTable& symbols) {
  logic::TptpOptions options;
  if (const char* root = std::getenv("TPTP"); root != nullptr) options.include_root = root;
  if (settings.file != "-") return logic::ReadTptpFile(settings.file, symbols, options);
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  return logic::ReadTptp(text, "-", symbols, options);
}

int RefuseInput(const ProveSettings& settings, const logic::TptpFile& input) {
  std::error_code error;
  const bool exists =
      settings.file == "-" || std::filesystem::is_regular_file(settings.file, error);
  fmt::print(stderr, "{}", Format(input.diagnostics));
  fmt::print("% SZS status {} for {}\n", exists ? "SyntaxError" : "InputError", settings.file);
  return kInvalidInput;
}

void PrintAnswers(const ProveSettings& settings, const pttp::ProverResult& result) {
  if (result.answers.empty()) return;
  std::vector<std::string> tuples;
  for (const auto& tuple : result.answers) {
    tuples.push_back(fmt::format("[{}]", fmt::join(tuple, ",")));
  }
  const std::string one = fmt::format("{}", fmt::join(tuples, "|"));
  fmt::print("% SZS answers Tuple [{}|_] for {}\n", tuples.size() == 1 ? one : "(" + one + ")",
             settings.file);
}

void PrintResult(const ProveSettings& settings, const pttp::ProverResult& result) {
  const bool proved =
      result.status == pttp::Szs::kTheorem || result.status == pttp::Szs::kUnsatisfiable;
  fmt::print("% SZS status {} for {}\n", Name(result.status), settings.file);
  if (!result.message.empty() && result.status == pttp::Szs::kGaveUp) {
    fmt::print("% {}\n", result.message);
  }
  if (settings.answers && proved) PrintAnswers(settings, result);
  if (settings.proof && proved) {
    fmt::print("% SZS output start Proof for {}\n", settings.file);
    for (const std::string& line : result.proof) fmt::print("{}\n", line);
    fmt::print("% SZS output end Proof for {}\n", settings.file);
  }
  if (settings.statistics) {
    fmt::print("% clauses {}\n% inferences {}\n% depth {}\n", result.clauses,
               result.statistics.inferences, result.statistics.depth);
  }
}

int RunProve(const ProveSettings& settings) {
  const auto start = std::chrono::steady_clock::now();
  logic::SymbolTable symbols;
  const logic::TptpFile input = Read(settings, symbols);
  if (!input.diagnostics.empty()) return RefuseInput(settings, input);
  pttp::ProverOptions options;
  options.budget.inferences = settings.inferences;
  options.budget.depth = settings.depth;
  options.budget.deadline = start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                        std::chrono::duration<double>(settings.seconds));
  options.proof = settings.proof || settings.answers;
  const pttp::ProverResult result = pttp::Prove(input.formulas, symbols, settings.file, options);
  PrintResult(settings, result);
  const bool proved =
      result.status == pttp::Szs::kTheorem || result.status == pttp::Szs::kUnsatisfiable;
  return proved ? kDone : kGoalNotReached;
}

}  // namespace

void AddProve(CLI::App& app, Context& context) {
  auto settings = std::make_shared<ProveSettings>();
  CLI::App* command =
      app.add_subcommand("prove", "Prove the conjecture of a TPTP file, or refute its clauses");
  command->add_option("FILE", settings->file, "TPTP file (CNF, FOF); '-' reads standard input")
      ->required();
  command->add_option("--time", settings->seconds, "Seconds to spend")
      ->check(CLI::Range(0.001, 1e6))
      ->capture_default_str();
  command->add_option("--inferences", settings->inferences, "Inferences to spend");
  command->add_option("--depth", settings->depth, "Deepest path to search")
      ->check(CLI::Range(1U, 1'000'000U));
  command->add_flag("--proof", settings->proof, "Print the proof in TSTP syntax");
  command->add_flag("--answers", settings->answers,
                    "Print the values of the conjecture's variables");
  command->add_flag("--stats", settings->statistics, "Print what the search cost");
  command->callback([settings, &context] { context.exit_code = RunProve(*settings); });
}

}  // namespace latchwork::app

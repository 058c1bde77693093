// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "apps/check_proof/proof_checker.h"
#include "apps/latchwork/command.h"
#include "apps/latchwork/tptp_input.h"

namespace latchwork::app {
namespace {

using check_proof::CheckedStep;
using check_proof::StepState;

struct CheckProofSettings {
  TptpInput problem;
  TptpInput proof;
  bool json = false;
};

std::string_view Name(StepState state) {
  switch (state) {
    case StepState::kVerified:
      return "verified";
    case StepState::kRejected:
      return "rejected";
    default:
      return "not checked";
  }
}

std::size_t Count(const std::vector<CheckedStep>& steps, StepState state) {
  return static_cast<std::size_t>(
      std::count_if(steps.begin(), steps.end(),
                    [state](const CheckedStep& step) { return step.state == state; }));
}

StepState Verdict(const std::vector<CheckedStep>& steps) {
  if (Count(steps, StepState::kRejected) > 0) return StepState::kRejected;
  return Count(steps, StepState::kUnchecked) > 0 ? StepState::kUnchecked : StepState::kVerified;
}

void PrintJson(const std::vector<CheckedStep>& steps) {
  nlohmann::ordered_json report{{"verdict", Name(Verdict(steps))},
                                {"verified", Count(steps, StepState::kVerified)},
                                {"rejected", Count(steps, StepState::kRejected)},
                                {"not_checked", Count(steps, StepState::kUnchecked)},
                                {"steps", nlohmann::ordered_json::array()}};
  for (const CheckedStep& step : steps) {
    if (step.state == StepState::kVerified) continue;
    report["steps"].push_back({{"name", step.name},
                               {"line", step.place.line},
                               {"column", step.place.column},
                               {"state", Name(step.state)},
                               {"reason", step.reason}});
  }
  fmt::print("{}\n", report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

void PrintText(const std::vector<CheckedStep>& steps) {
  for (const CheckedStep& step : steps) {
    if (step.state == StepState::kVerified) continue;
    const std::string subject = step.name.empty() ? "" : fmt::format("step '{}': ", step.name);
    const std::string message = fmt::format("{}{}: {}", subject, Name(step.state), step.reason);
    fmt::print(stderr, "{}", Format(logic::Diagnostic{step.place, message, {}, {}}));
  }
  fmt::print("{}: {} steps verified, {} rejected, {} not checked\n", Name(Verdict(steps)),
             Count(steps, StepState::kVerified), Count(steps, StepState::kRejected),
             Count(steps, StepState::kUnchecked));
}

int RunCheckProof(const CheckProofSettings& settings) {
  logic::SymbolTable symbols;
  const logic::TptpFile problem = Read(settings.problem, symbols);
  const logic::TptpFile proof = Read(settings.proof, symbols, Keep::kSources);
  if (!problem.diagnostics.empty() || !proof.diagnostics.empty()) {
    fmt::print(stderr, "{}{}", Format(problem.diagnostics), Format(proof.diagnostics));
    return kInvalidInput;
  }
  const std::vector<CheckedStep> steps = check_proof::CheckProof(problem, proof, symbols);
  settings.json ? PrintJson(steps) : PrintText(steps);
  switch (Verdict(steps)) {
    case StepState::kVerified:
      return kDone;
    case StepState::kRejected:
      return kDiverged;
    default:
      return kGoalNotReached;
  }
}

}  // namespace

void AddCheckProof(CLI::App& app, Context& context) {
  auto settings = std::make_shared<CheckProofSettings>();
  settings->proof.file = "-";
  CLI::App* command = app.add_subcommand(
      "check-proof", "Check a proof in TSTP syntax against its problem, independently");
  command->add_option("PROBLEM", settings->problem.file, "TPTP file of the problem")->required();
  command->add_option("PROOF", settings->proof.file,
                      "File with the proof, such as the output of 'prove --proof'; '-' (default) "
                      "reads standard input");
  AddTptpFolder(*command, settings->problem);
  command->add_flag("--json", settings->json, "Print the verdict as JSON");
  command->footer(
      "Exit codes: 0 every step is verified; 1 no step is wrong, but some could not be checked;\n"
      "3 a file cannot be read; 6 a step is wrong.");
  command->callback([settings, &context] { context.exit_code = RunCheckProof(*settings); });
}

}  // namespace latchwork::app

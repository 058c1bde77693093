// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/latchwork/icarus_command.h"
#include "apps/latchwork/icarus_trace_json.h"
#include "reasoners/icarus/recognition/recogniser.h"

namespace latchwork::app {
namespace {

struct Settings {
  std::string recording;
  std::vector<std::string> programs;
  std::vector<std::string> tops;
  bool json = false;
};

struct Candidate {
  std::string program;
  std::string top;
  icarus::Evidence evidence;
  double probability = 0;
};

bool IsGood(const std::string& file, const icarus::Findings& findings) {
  if (!icarus::HasErrors(findings)) return true;
  PrintFindings(file, findings);
  return false;
}

/// `top`, which is weighed with the recording, or the recording.
std::string FileOf(const icarus::Findings& findings, const std::string& otherwise) {
  return findings.empty() ? otherwise : findings.front().diagnostic.place.file;
}

bool RefuseEmpty(const std::string& recording) {
  fmt::print(stderr,
             "{}: error: the recording shows nothing that was done\n  hint: say it in each cycle: "
             "(cycle ... (expect {{act}}))\n",
             recording);
  return false;
}

/// Every plan of the program that is named; false when something is wrong.
bool WeighProgram(const Settings& settings, const std::string& file, const std::string& recording,
                  std::vector<Candidate>& candidates) {
  std::optional<std::string> text = ReadProgramText(file);
  if (!text) return false;
  const icarus::ProgramFile program = icarus::ReadProgram(*std::move(text), file);
  if (!IsGood(file, program.findings)) return false;
  for (const std::string& top : settings.tops) {
    icarus::Findings findings;
    Candidate candidate{file, top, {}, 0};
    candidate.evidence =
        icarus::WeighPlan(program.program, top, recording, settings.recording, findings);
    if (!IsGood(FileOf(findings, settings.recording), findings)) return false;
    if (candidate.evidence.cycles == 0) return RefuseEmpty(settings.recording);
    candidates.push_back(std::move(candidate));
  }
  return true;
}

void Rank(std::vector<Candidate>& candidates) {
  std::vector<icarus::Evidence> evidence;
  for (const Candidate& candidate : candidates) evidence.push_back(candidate.evidence);
  const std::vector<double> shares = icarus::Posterior(evidence);
  for (std::size_t i = 0; i < shares.size(); ++i) candidates[i].probability = shares[i];
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) {
                     return a.evidence.log_likelihood > b.evidence.log_likelihood;
                   });
}

void PrintText(const std::vector<Candidate>& candidates, bool several_programs) {
  fmt::print("{:>11}  {:>9}  {:>9}  plan\n", "probability", "explained", "precision");
  for (const Candidate& of : candidates) {
    const icarus::Evidence& evidence = of.evidence;
    fmt::print("{:>11.4f}  {:>9}  {:>9.2f}  {}{}\n", of.probability,
               fmt::format("{}/{}", evidence.explained, evidence.cycles), evidence.precision,
               of.top, several_programs ? " of " + of.program : "");
  }
  for (const Candidate& of : candidates) {
    if (of.evidence.unanswered.empty()) continue;
    fmt::print(stderr, "{}: note: not in the recording, so False: {}\n", of.program,
               fmt::join(of.evidence.unanswered, ", "));
    if (!several_programs) return;
  }
}

void PrintJson(const std::vector<Candidate>& candidates) {
  for (const Candidate& of : candidates) {
    const nlohmann::ordered_json line = {{"program", of.program},
                                         {"top", of.top},
                                         {"probability", of.probability},
                                         {"cycles", of.evidence.cycles},
                                         {"explained", of.evidence.explained},
                                         {"precision", of.evidence.precision},
                                         {"log_likelihood", of.evidence.log_likelihood},
                                         {"unanswered", of.evidence.unanswered}};
    fmt::print("{}\n", line.dump());
  }
}

/// A script, as it is or made of a trace; nothing, with a message, when it cannot be read.
std::optional<std::string> ReadRecording(const std::string& file) {
  std::optional<std::string> text = ReadProgramText(file);
  if (!text || !text->starts_with('{')) return text;
  std::optional<RecordedTrace> trace = ReadTrace(*text, file, true);
  if (!trace) return std::nullopt;
  return std::move(trace->script);
}

int Recognise(const Settings& settings) {
  const std::optional<std::string> recording = ReadRecording(settings.recording);
  if (!recording) return kInvalidInput;
  std::vector<Candidate> candidates;
  for (const std::string& program : settings.programs) {
    if (!WeighProgram(settings, program, *recording, candidates)) return kInvalidInput;
  }
  Rank(candidates);
  if (settings.json) {
    PrintJson(candidates);
  } else {
    PrintText(candidates, settings.programs.size() > 1);
  }
  return kDone;
}

}  // namespace

void AddIcarusRecognise(CLI::App& icarus, Context& context) {
  CLI::App* command = icarus.add_subcommand(
      "recognise", "Rank plans by how well they account for what an agent was seen to do");
  const auto settings = std::make_shared<Settings>();
  command
      ->add_option("RECORDING", settings->recording,
                   "World script whose (expect ...) says what was done in each cycle, or a trace "
                   "that 'icarus trace --json' printed")
      ->required();
  command->add_option("PROGRAM", settings->programs, "Programs that have the plans")->required();
  command->add_option("--top", settings->tops, "A plan: \"(Skill argument ...)\"; may be repeated")
      ->required();
  command->add_flag("--json", settings->json, "Print one JSON object per plan");
  command->callback([settings, &context] { context.exit_code = Recognise(*settings); });
}

}  // namespace latchwork::app

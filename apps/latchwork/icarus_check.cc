// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/latchwork/icarus_command.h"
#include "apps/latchwork/icarus_layers.h"
#include "latchwork/logic/diagnostic.h"

namespace latchwork::app {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::vector<std::string> files;
  icarus::CheckOptions options;
  std::string explain;
  std::string layer;
  std::string scenario;
  bool warnings_are_errors = false;
  bool json = false;
};

Json PlaceToJson(const logic::Diagnostic& diagnostic) {
  return {{"file", diagnostic.place.file},
          {"line", diagnostic.place.line},
          {"column", diagnostic.place.column}};
}

Json ToJson(const icarus::Finding& finding) {
  Json object = PlaceToJson(finding.diagnostic);
  object["severity"] = finding.severity == icarus::Severity::kError ? "error" : "warning";
  object["code"] = icarus::Info(finding.code).name;
  object["message"] = finding.diagnostic.message;
  object["hint"] = finding.diagnostic.hint;
  if (finding.note) {
    object["note"] = PlaceToJson(*finding.note);
    object["note"]["message"] = finding.note->message;
  }
  return object;
}

void PrintSummary(const std::string& file, const icarus::Program& program) {
  fmt::print("{}: ok: {} skill{}, {} constant{}, {} fact{}\n", file, program.skills.size(),
             program.skills.size() == 1 ? "" : "s", program.constants.size() - 1,
             program.constants.size() == 2 ? "" : "s", program.facts.size(),
             program.facts.size() == 1 ? "" : "s");
}

/// What checks of programs came to.
struct Report {
  Json list = Json::array();
  int exit_code = kDone;

  void Worsen(int code) { exit_code = std::max(exit_code, code); }
};

/// `name` is what a person knows the program by.
void Judge(const Settings& settings, const std::string& name, const icarus::ProgramFile& read,
           Report& report) {
  const bool missing_top =
      !settings.options.top.empty() && read.program.Find(settings.options.top) == icarus::kNoSkill;
  const bool bad = missing_top || icarus::HasErrors(read.findings) ||
                   (settings.warnings_are_errors && !read.findings.empty());
  if (missing_top) {
    fmt::print(stderr, "{}: error: there is no skill '{}'\n", name, settings.options.top);
  }
  if (bad) report.Worsen(kInvalidInput);
  if (settings.json) {
    for (const icarus::Finding& finding : read.findings) report.list.push_back(ToJson(finding));
  } else {
    PrintFindings(name, read.findings);
    if (!bad) PrintSummary(name, read.program);
  }
}

/// Reads a program and checks it, as the body of the layer where there is one.
void CheckFile(const Settings& settings, const std::string& file, LayerToFulfil* layer,
               const std::string& name, Report& report) {
  std::optional<std::string> text = ReadProgramText(file);
  if (!text) return report.Worsen(kInvalidInput);
  icarus::CheckOptions options = settings.options;
  if (layer != nullptr) options.facts = layer->facts();
  icarus::ProgramFile read = icarus::ReadProgram(*std::move(text), file, options);
  if (layer != nullptr && !icarus::HasErrors(read.findings)) {
    const icarus::Findings more = layer->Check(read.program);
    read.findings.insert(read.findings.end(), more.begin(), more.end());
    icarus::Settle(read.program.source, read.findings);
  }
  Judge(settings, name, read, report);
}

bool IsAgentFile(const std::string& file) {
  return std::filesystem::path(file).extension() == ".xml";
}

/// Checks each program of an agent against its layer.
void CheckAgent(const Settings& settings, const std::string& file, const Context& context,
                Report& report) {
  ProgramsOfAgent programs(file, settings.scenario, context);
  if (!programs.diagnostics().empty()) {
    fmt::print(stderr, "{}", logic::Format(programs.diagnostics()));
    return report.Worsen(programs.plugin_failure() ? kPluginFailure : kInvalidInput);
  }
  for (LayerToFulfil& layer : programs.layers()) {
    for (const std::filesystem::path& program : layer.files()) {
      CheckFile(settings, program.string(), &layer,
                fmt::format("{}: {}", layer.name(), program.filename().string()), report);
    }
  }
  if (programs.layers().empty() && !settings.json) {
    fmt::print("{}: ok: no layer has an Icarus program for a body\n", file);
  }
}

int Explain(const std::string& wanted) {
  const auto codes = icarus::AllCodes();
  const auto code = std::find_if(codes.begin(), codes.end(), [&](const icarus::CodeInfo& info) {
    return icarus::Fold(info.name) == icarus::Fold(wanted);
  });
  if (code == codes.end()) {
    fmt::print(stderr, "latchwork: there is no code '{}'; they are {} to {}\n", wanted,
               codes.front().name, codes.back().name);
    return kUsage;
  }
  fmt::print("{} ({}): {}\n", code->name,
             code->severity == icarus::Severity::kError ? "error" : "warning", code->explanation);
  return kDone;
}

int Run(const Settings& settings, const Context& context) {
  if (!settings.explain.empty()) return Explain(settings.explain);
  if (settings.files.empty()) {
    fmt::print(stderr, "latchwork: name at least one program\n");
    return kUsage;
  }
  std::optional<NamedLayer> layer;
  if (!settings.layer.empty()) layer.emplace(settings.layer, context);
  if (layer && !layer->error().empty()) {
    fmt::print(stderr, "latchwork: {}\n", layer->error());
    return kPluginFailure;
  }
  Report report;
  for (const std::string& file : settings.files) {
    if (IsAgentFile(file)) {
      CheckAgent(settings, file, context, report);
    } else {
      CheckFile(settings, file, layer ? &layer->layer() : nullptr, file, report);
    }
  }
  if (settings.json) {
    fmt::print("{}\n", report.list.dump(2, ' ', false, Json::error_handler_t::replace));
  }
  return report.exit_code;
}

}  // namespace

void AddIcarusCheck(CLI::App& icarus, Context& context) {
  CLI::App* command =
      icarus.add_subcommand("check", "Check programs without running them: errors and warnings");
  const auto settings = std::make_shared<Settings>();
  command->add_option("FILE", settings->files,
                      "Programs; - is standard input. Of an agent file (.xml) each layer that has "
                      "a program, as its body");
  command->add_option("--scenario", settings->scenario,
                      "A file of overrides that comes on top of agent files");
  command->add_option("--top", settings->options.top,
                      "The skill that the program is started with; what it does not lead to is "
                      "reported");
  command->add_option("--layer", settings->layer,
                      "The layer plugin whose body the programs are: its contract, attachments and "
                      "parameters are checked, too");
  command->add_flag("--strict", settings->options.strict,
                    "Fewer arguments than parameters are an error");
  command->add_flag("--werror", settings->warnings_are_errors, "Warnings make the exit code 3");
  command->add_flag("--json", settings->json, "Print the findings as a JSON list");
  command->add_option("--explain", settings->explain, "Say what a code, such as I015, means");
  command->callback([settings, &context] { context.exit_code = Run(*settings, context); });
}

}  // namespace latchwork::app

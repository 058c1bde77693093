// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/latchwork/icarus_command.h"

namespace latchwork::app {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::vector<std::string> files;
  icarus::CheckOptions options;
  std::string explain;
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

/// Whether the file may be used.
bool CheckFile(const Settings& settings, const std::string& file, Json& list) {
  std::optional<std::string> text = ReadProgramText(file);
  if (!text) return false;
  const icarus::ProgramFile read = icarus::ReadProgram(*std::move(text), file, settings.options);
  const bool missing_top =
      !settings.options.top.empty() && read.program.Find(settings.options.top) == icarus::kNoSkill;
  const bool bad = missing_top || icarus::HasErrors(read.findings) ||
                   (settings.warnings_are_errors && !read.findings.empty());
  if (missing_top) {
    fmt::print(stderr, "{}: error: there is no skill '{}'\n", file, settings.options.top);
  }
  if (settings.json) {
    for (const icarus::Finding& finding : read.findings) list.push_back(ToJson(finding));
  } else {
    PrintFindings(file, read.findings);
    if (!bad) PrintSummary(file, read.program);
  }
  return !bad;
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

int Run(const Settings& settings) {
  if (!settings.explain.empty()) return Explain(settings.explain);
  if (settings.files.empty()) {
    fmt::print(stderr, "latchwork: name at least one program\n");
    return kUsage;
  }
  bool all_good = true;
  Json list = Json::array();
  for (const std::string& file : settings.files) {
    all_good = CheckFile(settings, file, list) && all_good;
  }
  if (settings.json) {
    fmt::print("{}\n", list.dump(2, ' ', false, Json::error_handler_t::replace));
  }
  return all_good ? kDone : kInvalidInput;
}

}  // namespace

void AddIcarusCheck(CLI::App& icarus, Context& context) {
  CLI::App* command =
      icarus.add_subcommand("check", "Check programs without running them: errors and warnings");
  const auto settings = std::make_shared<Settings>();
  command->add_option("FILE", settings->files, "Programs; - is standard input");
  command->add_option("--top", settings->options.top,
                      "The skill that the program is started with; what it does not lead to is "
                      "reported");
  command->add_flag("--strict", settings->options.strict,
                    "Fewer arguments than parameters are an error");
  command->add_flag("--werror", settings->warnings_are_errors, "Warnings make the exit code 3");
  command->add_flag("--json", settings->json, "Print the findings as a JSON list");
  command->add_option("--explain", settings->explain, "Say what a code, such as I015, means");
  command->callback([settings, &context] { context.exit_code = Run(*settings); });
}

}  // namespace latchwork::app

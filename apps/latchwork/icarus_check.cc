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
#include "latchwork/logic/diagnostic.h"
#include "latchwork/plugin/plugin_search.h"
#include "latchwork/plugin/registry.h"
#include "latchwork/sdk/contract_body.h"
#include "reasoners/icarus/body/layer_check.h"

namespace latchwork::app {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::vector<std::string> files;
  icarus::CheckOptions options;
  std::string explain;
  std::string layer;
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

/// The layer whose body the programs are to be, with its parameters as they are by default.
class LayerToFulfil {
 public:
  LayerToFulfil(const std::string& name, const Context& context)
      : registry_(plugin::MakeSearchPath(context.plugin_folders, context.executable)),
        layer_(registry_.MakeLayer(name)) {
    if (!layer_.object) return;
    const auto parameters = sdk::Parameters::Defaults(layer_.object->parameters());
    const std::vector<std::string> languages = layer_.object->languages();
    if (std::find(languages.begin(), languages.end(), "icarus") != languages.end()) {
      body_ = layer_.object->MakeBody(
          "icarus", parameters, registry_.DataFolder(sdk::PluginKind::kLayer, name), symbols_);
    } else {
      body_ = sdk::ContractBody(layer_.object->contract(), "icarus", symbols_);
      body_.facts = sdk::ParameterFacts(parameters, symbols_);
    }
  }

  /// Why there is no such layer; empty: there is.
  const std::string& error() const { return layer_.error; }
  icarus::Findings Check(const icarus::Program& program) {
    return icarus::CheckInLayer(program, body_, symbols_);
  }

 private:
  logic::SymbolTable symbols_;
  plugin::Registry registry_;
  plugin::Made<sdk::Layer> layer_;
  sdk::Body body_;
};

/// Whether the file may be used.
bool CheckFile(const Settings& settings, const std::string& file, LayerToFulfil* layer,
               Json& list) {
  std::optional<std::string> text = ReadProgramText(file);
  if (!text) return false;
  icarus::ProgramFile read = icarus::ReadProgram(*std::move(text), file, settings.options);
  if (layer != nullptr && !icarus::HasErrors(read.findings)) {
    const icarus::Findings more = layer->Check(read.program);
    read.findings.insert(read.findings.end(), more.begin(), more.end());
    icarus::Settle(read.program.source, read.findings);
  }
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

int Run(const Settings& settings, const Context& context) {
  if (!settings.explain.empty()) return Explain(settings.explain);
  if (settings.files.empty()) {
    fmt::print(stderr, "latchwork: name at least one program\n");
    return kUsage;
  }
  std::optional<LayerToFulfil> layer;
  if (!settings.layer.empty()) layer.emplace(settings.layer, context);
  if (layer && !layer->error().empty()) {
    fmt::print(stderr, "latchwork: {}\n", layer->error());
    return kPluginFailure;
  }
  bool all_good = true;
  Json list = Json::array();
  for (const std::string& file : settings.files) {
    all_good = CheckFile(settings, file, layer ? &*layer : nullptr, list) && all_good;
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

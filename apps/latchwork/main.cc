// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "apps/compare/runs/serve_runs.h"
#include "apps/latchwork/command.h"
#include "apps/latchwork/standard_streams.h"
#include "latchwork/logic/diagnostic.h"

namespace latchwork::app {
namespace {

constexpr std::string_view kExitCodes =
    "Exit codes: 0 done; 1 the run ended without reaching its goal; 2 wrong usage; 3 invalid "
    "input;\n"
    "4 a plugin cannot be loaded; 5 internal error; 6 replay diverged, proof rejected, layers "
    "mean\n"
    "something else, or reasoners disagree; 7 deadline missed.\n\n"
    "Start here: latchwork run examples/office/scenario1.xml --out out/scenario1\n";

std::vector<std::string> SubcommandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* subcommand : app.get_subcommands(nullptr)) {
    names.push_back(subcommand->get_name());
  }
  return names;
}

int ReportUsage(const CLI::App& app, const CLI::ParseError& error,
                const std::vector<std::string>& words) {
  std::string path;
  const CLI::App* chosen = &app;
  while (!chosen->get_subcommands().empty()) {
    chosen = chosen->get_subcommands().front();
    path += chosen->get_name() + ' ';
  }
  if (words.size() > 1 && chosen == &app && !words[1].starts_with('-')) {
    fmt::print(stderr, "latchwork: there is no command '{}'\n", words[1]);
    const std::vector<std::string> names = SubcommandNames(app);
    const std::string_view nearest = logic::NearestName(words[1], names);
    if (!nearest.empty()) fmt::print(stderr, "  did you mean '{}'?\n", nearest);
  } else {
    fmt::print(stderr, "latchwork: {}\n", error.what());
  }
  fmt::print(stderr, "  see: latchwork {}--help\n", path);
  return kUsage;
}

std::filesystem::path ExecutablePath(const char* invoked_as) {
  std::error_code error;
  std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::path(invoked_as) : path;
}

struct Command {
  std::string_view name;
  void (*add)(CLI::App&, Context&);
};

constexpr std::array<Command, 13> kCommands{{{"run", &AddRun},
                                             {"check", &AddCheck},
                                             {"prove", &AddProve},
                                             {"check-proof", &AddCheckProof},
                                             {"entail", &AddEntail},
                                             {"semantics", &AddSemantics},
                                             {"explain", &AddExplain},
                                             {"compare", &AddCompare},
                                             {compare::kForkServerCommand, &AddForkServer},
                                             {"diff-reasoners", &AddDiffReasoners},
                                             {"replay", &AddReplay},
                                             {"icarus", &AddIcarus},
                                             {"plugin", &AddPlugin}}};

/// The one that is asked for, so that none pays for the options of all; where that is not plain,
/// all of them.
void AddCommands(CLI::App& app, const std::vector<std::string>& words, Context& context) {
  const auto* const asked = std::ranges::find_if(kCommands, [&](const Command& command) {
    return words.size() > 1 && command.name == words[1];
  });
  if (asked != kCommands.end()) return asked->add(app, context);
  for (const Command& command : kCommands) command.add(app, context);
}

int Parse(const std::vector<std::string>& words, Context& context) {
  CLI::App app("latchwork: robots controlled by layers of reasoning", "latchwork");
  app.footer(std::string(kExitCodes));
  app.require_subcommand(1);
  app.set_version_flag("--version", "latchwork " LATCHWORK_VERSION);
  app.add_option("--plugin-path", context.plugin_folders,
                 "Folder to search for plugins first; may be repeated")
      ->allow_extra_args(false);
  app.fallthrough();
  AddCommands(app, words, context);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend() - 1));
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return ReportUsage(app, error, words);
  }
  return context.exit_code;
}

int Execute(const std::vector<std::string>& words, Context& context) {
  try {
    const int code = Parse(words, context);
    return OutputIsWhole() ? code : kInternalError;
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0 && !OutputIsWhole()) return kInternalError;
    std::fprintf(stderr, "latchwork: internal error: %s\n", error.what());
  } catch (...) {
    std::fputs("latchwork: internal error\n", stderr);
  }
  return kInternalError;
}

}  // namespace
}  // namespace latchwork::app

int main(int argc, char** argv) {
  latchwork::app::ReserveStandardStreams();
  latchwork::app::Context context;
  context.executable = latchwork::app::ExecutablePath(argv[0]);
  context.execute = latchwork::app::Execute;
  return latchwork::app::Execute({argv, argv + argc}, context);
}

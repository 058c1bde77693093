// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "apps/compare/runs/serve_runs.h"
#include "apps/latchwork/command.h"
#include "latchwork/config/agent.h"
#include "latchwork/config/xml.h"
#include "latchwork/plugin/preload.h"

namespace latchwork::app {
namespace {

using Libraries = std::vector<std::filesystem::path>;

std::atomic<bool> ended = false;
void End(int /*signal*/) { ended = true; }

/// Without the restarting of what waits.
void OnTermination(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigaction(SIGTERM, &action, nullptr);
}

std::ptrdiff_t CountThreads() {
  std::error_code error;
  const std::filesystem::directory_iterator threads("/proc/self/task", error);
  return error ? 1 : std::distance(begin(threads), end(threads));
}

/// Begins anew without a library: the way back to one thread. The server has said that it is ready
/// and goes on reading where it was.
[[noreturn]] void StartWithout(const Libraries& libraries, const Context& context) {
  std::vector<std::string> words = {context.executable.string()};
  const auto add = [&](const char* option, const Libraries& paths) {
    for (const std::filesystem::path& path : paths) {
      words.insert(words.end(), {option, path.string()});
    }
  };
  add("--plugin-path", context.plugin_folders);
  words.emplace_back(compare::kForkServerCommand);
  add("--without", libraries);
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execv(pointers.front(), pointers.data());
  _exit(kInternalError);
}

/// A library that starts threads when it is loaded is left to the runs: only a process with one
/// thread may be copied.
void Load(const std::filesystem::path& library, Libraries& without, const Context& context) {
  if (std::ranges::find(without, library) != without.end()) return;
  plugin::Preload(library);
  if (CountThreads() == 1) return;
  without.push_back(library);
  StartWithout(without, context);
}

int Run(const std::vector<std::string>& arguments,
        const std::function<void(const std::filesystem::path&)>& used, const Context& context) {
  OnTermination(SIG_DFL);
  Context own = context;
  own.used = used;
  std::vector<std::string> words = {"latchwork"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return context.execute(words, own);
}

void Serve(Libraries& without, Context& context) {
  OnTermination(End);
  config::ReadXmlText("<agent/>", "", config::AgentSchema());  // Loads what reads agent files.
  if (without.empty()) fmt::print("{}\n", compare::kReady);
  std::fflush(stdout);
  const compare::RunService service{
      [&](const auto& arguments, const auto& used) { return Run(arguments, used, context); },
      [&](const auto& library) { Load(library, without, context); }};
  if (compare::ServeRuns(service, STDIN_FILENO, STDOUT_FILENO, ended)) return;
  fmt::print(stderr, "latchwork: {} reads tasks of latchwork compare, and nothing else\n",
             compare::kForkServerCommand);
  context.exit_code = kUsage;
}

}  // namespace

void AddForkServer(CLI::App& app, Context& context) {
  auto* command =
      app.add_subcommand(std::string(compare::kForkServerCommand), "Make runs for others");
  command->group("");  // Not for people.
  auto without = std::make_shared<Libraries>();
  command->add_option("--without", *without, "Leave this library to the runs")
      ->allow_extra_args(false);
  command->callback([without, &context] { Serve(*without, context); });
}

}  // namespace latchwork::app

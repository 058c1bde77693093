// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "apps/latchwork/icarus_command.h"
#include "apps/latchwork/icarus_repl_commands.h"

namespace latchwork::app {
namespace {

constexpr std::size_t kMostLine = 1U << 16U;

/// False at the end of input. What is longer than a line may be is left out.
bool ReadLine(std::string& line) {
  line.clear();
  int next = 0;
  while ((next = std::cin.get()) != std::istream::traits_type::eof() && next != '\n') {
    if (line.size() <= kMostLine) line += static_cast<char>(next);
  }
  if (line.size() > kMostLine) line = "?";
  return next == '\n' || !line.empty();
}

/// Standard input and output.
class Console final : public IcarusConsole {
 public:
  explicit Console(bool prompts) : prompts_(prompts) {}

  bool Ask(const std::string& answer, std::string& line) override {
    fmt::print("{}{}", answer, prompts_ ? "> " : "");
    std::fflush(stdout);
    return ReadLine(line);
  }

 private:
  const bool prompts_;
};

int Run(const IcarusSettings& settings) {
  const auto debugger = std::make_unique<IcarusDebugger>(settings);
  if (settings.program == "-") {
    fmt::print(stderr, "latchwork: standard input is for commands; name a file\n");
    return kUsage;
  }
  if (!debugger->Open()) return kInvalidInput;
  const bool prompts = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  Console console(prompts);
  IcarusRepl repl(*debugger, console);
  if (prompts) fmt::print("{}: 'help' lists the commands\n", settings.program);
  std::string line;
  std::string out;
  bool going = true;
  while (going && console.Ask(out, line)) {
    out.clear();
    going = repl.Do(line, out);
  }
  if (!going) fmt::print("{}", out);
  return kDone;
}

}  // namespace

void AddIcarusRepl(CLI::App& icarus, Context& context) {
  CLI::App* command = icarus.add_subcommand(
      "repl", "Run a program step by step: break, watch, change the world, ask why and why not");
  const auto settings = std::make_shared<IcarusSettings>();
  command->footer(
      "Commands come from standard input, a line each ('help' lists them), so that a session can\n"
      "be written down and given again. Without --script every sensor is False until it is\n"
      "answered by hand. For editing and history of lines: rlwrap latchwork icarus repl ...\n"
      "Examples:\n"
      "  latchwork icarus repl bumper.icarus --script day.world\n"
      "  printf 'step 3\\nwhy\\nwhy-not Ram\\n' | latchwork icarus repl bumper.icarus --script "
      "day.world");
  command->add_option("PROGRAM", settings->program, "Program")->required();
  command->add_option("--script", settings->script, "What the world does, cycle by cycle");
  AddIcarusOptions(*command, *settings);
  command->callback([settings, &context] {
    TakeModes(*settings);
    context.exit_code = Run(*settings);
  });
}

}  // namespace latchwork::app

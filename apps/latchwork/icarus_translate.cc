// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "apps/latchwork/icarus_command.h"
#include "reasoners/icarus/translations/translate.h"

namespace latchwork::app {
namespace {

int Translate(const std::string& file) {
  std::optional<std::string> text = ReadProgramText(file);
  if (!text) return kInvalidInput;
  const icarus::ReactivePlanFile plans = icarus::ReadReactivePlans(*std::move(text), file);
  PrintFindings(file, plans.findings);
  if (icarus::HasErrors(plans.findings)) return kInvalidInput;
  fmt::print("{}", icarus::TranslateToIcarus(plans));
  return kDone;
}

}  // namespace

void AddIcarusTranslate(CLI::App& icarus, Context& context) {
  CLI::App* command = icarus.add_subcommand(
      "translate", "Print the program that acts like teleo-reactive trees and universal plans");
  const auto file = std::make_shared<std::string>();
  command->add_option("FILE", *file, "Trees and plans; - is standard input")->required();
  command->callback([file, &context] { context.exit_code = Translate(*file); });
}

}  // namespace latchwork::app

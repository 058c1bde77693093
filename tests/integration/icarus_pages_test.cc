// SPDX-License-Identifier: BSD-3-Clause
//
// The examples of the pages on Icarus come to what the pages print. A block "```icarus NAME" is a
// file; a block "```console" holds commands, each after "$ ", and their output.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

struct Block {
  std::size_t line = 0;
  std::string kind;
  std::string name;
  std::string text;
};

std::vector<Block> BlocksOf(const std::string& page) {
  std::vector<Block> blocks;
  std::istringstream lines(page);
  std::string line;
  bool inside = false;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (!inside) continue;
      Block& block = blocks.emplace_back();
      block.line = number;
      std::istringstream(line.substr(3)) >> block.kind >> block.name;
    } else if (inside) {
      blocks.back().text += line + '\n';
    }
  }
  return blocks;
}

/// Each command, and what should come of it.
std::vector<std::pair<std::string, std::string>> CommandsOf(const Block& block) {
  std::vector<std::pair<std::string, std::string>> commands;
  std::istringstream lines(block.text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("$ ")) {
      commands.emplace_back(line.substr(2), "");
    } else if (!commands.empty()) {
      commands.back().second += line + '\n';
    }
  }
  return commands;
}

void CheckPage(const std::string& name) {
  const test::TemporaryFolder scratch;
  const auto file = std::filesystem::path(LATCHWORK_SOURCE_DIR) / "docs" / name;
  std::size_t checked = 0;
  for (const Block& block : BlocksOf(ReadText(file))) {
    if (block.kind == "icarus") {
      ASSERT_FALSE(block.name.empty()) << name << ':' << block.line << ": no file name";
      WriteText(scratch.path() / block.name, block.text);
    }
    if (block.kind != "console") continue;
    for (const auto& [command, output] : CommandsOf(block)) {
      const CommandResult result = RunShell(command + " 2>&1", scratch.path());
      EXPECT_EQ(result.out, output) << name << ':' << block.line << ": " << command;
      ++checked;
    }
  }
  EXPECT_GE(checked, 5U) << "the examples of " << name << " were not found";
}

TEST(IcarusPagesTest, Reference_ExamplesComeToWhatIsPrinted) { CheckPage("icarus.md"); }

TEST(IcarusPagesTest, ForBehaviourTrees_ExamplesComeToWhatIsPrinted) {
  CheckPage("icarus-for-behaviour-trees.md");
}

}  // namespace
}  // namespace latchwork::testing

// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/page_examples.h"

#include <gtest/gtest.h>

#include <sstream>
#include <utility>
#include <vector>

#include "tests/integration/run_command.h"

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

}  // namespace

void CheckPage(const std::string& page, const std::string& language,
               const std::filesystem::path& folder, std::size_t least) {
  const auto file = std::filesystem::path(LATCHWORK_SOURCE_DIR) / "docs" / page;
  std::size_t checked = 0;
  for (const Block& block : BlocksOf(ReadText(file))) {
    if (block.kind == language) {
      ASSERT_FALSE(block.name.empty()) << page << ':' << block.line << ": no file name";
      WriteText(folder / block.name, block.text);
    }
    if (block.kind != "console") continue;
    for (const auto& [command, output] : CommandsOf(block)) {
      const CommandResult result = RunShell(command + " 2>&1", folder);
      EXPECT_EQ(result.out, output) << page << ':' << block.line << ": " << command;
      ++checked;
    }
  }
  EXPECT_GE(checked, least) << "the examples of " << page << " were not found";
}

}  // namespace latchwork::testing

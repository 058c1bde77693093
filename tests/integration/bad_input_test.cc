// SPDX-License-Identifier: BSD-3-Clause
//
// What a person can get wrong, each as a file bad_input/NAME.expected:
//
//   $ latchwork check missing_world.xml
//   exit 3
//   missing_world.xml:2:1: error: ...
//
// The command runs in that folder. Every line below `exit` must stand in what it says, and it must
// say no other errors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/run_command.h"

namespace latchwork::testing {
namespace {

const std::filesystem::path kFolder =
    std::filesystem::path(LATCHWORK_SOURCE_DIR) / "tests/integration/bad_input";

struct Case {
  std::string name;
  std::vector<std::string> arguments;
  int exit_code = 0;
  std::vector<std::string> lines;
};

void PrintTo(const Case& bad, std::ostream* stream) { *stream << bad.name; }

std::vector<std::string> Words(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

Case ReadCase(const std::filesystem::path& file) {
  std::istringstream stream(ReadText(file));
  Case bad;
  bad.name = file.stem().string();
  std::string line;
  std::getline(stream, line);
  bad.arguments = Words(line);
  bad.arguments.erase(bad.arguments.begin(), bad.arguments.begin() + 2);  // $ latchwork
  std::getline(stream, line);
  bad.exit_code = std::stoi(Words(line).at(1));
  while (std::getline(stream, line)) {
    if (!line.empty()) bad.lines.push_back(line);
  }
  return bad;
}

std::vector<Case> ReadCases() {
  std::vector<Case> cases;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".expected") cases.push_back(ReadCase(entry.path()));
  }
  std::sort(cases.begin(), cases.end(),
            [](const Case& a, const Case& b) { return a.name < b.name; });
  return cases;
}

std::ptrdiff_t CountErrors(const std::vector<std::string>& lines) {
  return std::count_if(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find(": error: ") != std::string::npos;
  });
}

std::vector<std::string> Lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class BadInputTest : public ::testing::TestWithParam<Case> {};

TEST_P(BadInputTest, IsExplained) {
  const Case& bad = GetParam();
  const CommandResult result = RunLatchwork(bad.arguments, kFolder);
  const std::vector<std::string> said = Lines(result.err + result.out);
  EXPECT_EQ(result.exit_code, bad.exit_code);
  for (const std::string& line : bad.lines) EXPECT_THAT(said, ::testing::Contains(line));
  EXPECT_EQ(CountErrors(said), CountErrors(bad.lines)) << result.err;
}

INSTANTIATE_TEST_SUITE_P(Files, BadInputTest, ::testing::ValuesIn(ReadCases()),
                         [](const auto& named) { return named.param.name; });

TEST(BadInputTest, HasAtLeastFortyCases) { EXPECT_GE(ReadCases().size(), 40U); }

}  // namespace
}  // namespace latchwork::testing

// SPDX-License-Identifier: BSD-3-Clause
//
// The examples of the pages on Icarus come to what the pages print.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/integration/page_examples.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

TEST(IcarusPagesTest, Reference_ExamplesComeToWhatIsPrinted) {
  const test::TemporaryFolder scratch;
  for (const char* const folder : {"examples", "plugins"}) {
    std::filesystem::create_directory_symlink(std::string(LATCHWORK_SOURCE_DIR "/") + folder,
                                              scratch.path() / folder);
  }
  CheckPage("icarus.md", "icarus", scratch.path(), 5);
}

TEST(IcarusPagesTest, ForBehaviourTrees_ExamplesComeToWhatIsPrinted) {
  const test::TemporaryFolder scratch;
  CheckPage("icarus-for-behaviour-trees.md", "icarus", scratch.path(), 5);
}

}  // namespace
}  // namespace latchwork::testing

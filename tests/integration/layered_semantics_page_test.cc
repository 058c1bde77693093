// SPDX-License-Identifier: BSD-3-Clause
//
// The examples of the page on layered theories, and its files, come to what the page prints.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/integration/page_examples.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

TEST(LayeredSemanticsPageTest, ExamplesComeToWhatIsPrinted) {
  const test::TemporaryFolder scratch;
  std::filesystem::create_directory_symlink(LATCHWORK_SOURCE_DIR "/examples",
                                            scratch.path() / "examples");
  CheckPage("layered-semantics.md", "lay", scratch.path(), 4);
}

}  // namespace
}  // namespace latchwork::testing

// SPDX-License-Identifier: BSD-3-Clause
//
// The examples of the pages on Icarus come to what the pages print.
#include <gtest/gtest.h>

#include "tests/integration/page_examples.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

TEST(IcarusPagesTest, Reference_ExamplesComeToWhatIsPrinted) {
  const test::TemporaryFolder scratch;
  CheckPage("icarus.md", "icarus", scratch.path(), 5);
}

TEST(IcarusPagesTest, ForBehaviourTrees_ExamplesComeToWhatIsPrinted) {
  const test::TemporaryFolder scratch;
  CheckPage("icarus-for-behaviour-trees.md", "icarus", scratch.path(), 5);
}

}  // namespace
}  // namespace latchwork::testing

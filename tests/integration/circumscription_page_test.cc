// SPDX-License-Identifier: BSD-3-Clause
//
// The examples of the page on circumscription come to what it prints.
#include <gtest/gtest.h>

#include "tests/integration/page_examples.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

TEST(CircumscriptionPageTest, ExamplesComeToWhatIsPrinted) {
  const test::TemporaryFolder scratch;
  CheckPage("circumscription.md", "tptp", scratch.path(), 9);
}

}  // namespace
}  // namespace latchwork::testing

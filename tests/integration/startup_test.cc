// SPDX-License-Identifier: BSD-3-Clause
//
// What a command loads before it knows what it is asked for: little.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using test::TemporaryFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// What the loader says of the libraries of this run of the command.
std::string Loaded(const std::string& arguments, const std::filesystem::path& folder) {
  return RunShell("LD_DEBUG=files latchwork " + arguments, folder).err;
}

TEST(StartupTest, Prove_LoadsNothingOfXerces) {
  const TemporaryFolder scratch;
  WriteText(scratch.path() / "problem.p", "fof(a, axiom, p). fof(c, conjecture, p).");
  EXPECT_THAT(Loaded("prove problem.p", scratch.path()),
              AllOf(HasSubstr("liblatchwork.so"), Not(HasSubstr("liblatchwork_xml")),
                    Not(HasSubstr("libxerces"))));
}

TEST(StartupTest, Check_LoadsXerces) {
  const TemporaryFolder scratch;
  EXPECT_THAT(
      Loaded("check " LATCHWORK_SOURCE_DIR "/examples/office/scenario1.xml", scratch.path()),
      AllOf(HasSubstr("liblatchwork_xml"), HasSubstr("libxerces")));
}

/// A copy of the command and its library, without the module.
TEST(StartupTest, MissingXmlModule_IsSaid) {
  namespace fs = std::filesystem;
  const TemporaryFolder scratch;
  fs::create_directories(scratch.path() / "lib");
  fs::copy(LATCHWORK_BINARY_DIR "/lib/liblatchwork.so", scratch.path() / "lib");
  const CommandResult result = RunShell("LD_LIBRARY_PATH=lib latchwork check " LATCHWORK_SOURCE_DIR
                                        "/examples/office/scenario1.xml",
                                        scratch.path());
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.err, AllOf(HasSubstr("the reader of XML files cannot be loaded"),
                                HasSubstr("liblatchwork_xml.so")));
}

}  // namespace
}  // namespace latchwork::testing

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/plugin/plugin_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/temporary_folder.h"

namespace latchwork::plugin {
namespace {

using std::filesystem::path;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(PluginSearchTest, SearchPath_GivenThenEnvironmentThenBesideTheExecutable) {
  EXPECT_THAT(MakeSearchPath(std::vector<path>{"/given/b", "/given/a/"},
                             "/env/1::/env/2:", "/opt/x/bin/latchwork"),
              ElementsAre("/given/b", "/given/a", "/env/1", "/env/2", "/opt/x/plugins",
                          "/opt/x/lib/latchwork/plugins"));
}

TEST(PluginSearchTest, SearchPath_IsAbsoluteAndNamesEachFolderOnce) {
  const TemporaryFolder folder;
  std::filesystem::create_directory_symlink(folder.path(), folder.path() / "self");
  const std::vector<path> given{folder.path() / "." / "", folder.path() / "self", "here"};
  const std::vector<path> found = MakeSearchPath(given, folder.path().string(), "/bin/latchwork");
  EXPECT_THAT(found, ElementsAre(folder.path(), std::filesystem::current_path() / "here",
                                 "/plugins", "/lib/latchwork/plugins"));
}

TEST(PluginSearchTest, Folder_GivesItsLibrariesSortedAndNothingElse) {
  const TemporaryFolder folder;
  for (const char* name : {"b.so", "a.so", "c.so.1", "readme.txt"}) folder.Write(name, "");
  std::filesystem::create_directories(folder.path() / "sub.d");
  folder.Write("sub.d/z.so", "");
  const auto found = SearchPlugins(std::vector{folder.path()});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].files, ElementsAre(folder.path() / "a.so", folder.path() / "b.so"));
  EXPECT_THAT(found[0].problem, IsEmpty());
}

TEST(PluginSearchTest, EmptyFolder_IsNoProblem) {
  const TemporaryFolder folder;
  const auto found = SearchPlugins(std::vector{folder.path()});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].files, IsEmpty());
  EXPECT_THAT(found[0].problem, IsEmpty());
}

TEST(PluginSearchTest, MissingFolder_SaysSo) {
  const TemporaryFolder folder;
  const auto found = SearchPlugins(std::vector{folder.path() / "none"});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].problem, "No such file or directory");
}

TEST(PluginSearchTest, SameFileInTwoFolders_CountsWhereItIsReachedFirst) {
  const TemporaryFolder first;
  const TemporaryFolder second;
  first.Write("real.so", "");
  std::filesystem::create_symlink(first.path() / "real.so", second.path() / "link.so");
  const auto found = SearchPlugins(std::vector{second.path(), first.path()});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(found[0].files, ElementsAre(second.path() / "link.so"));
  EXPECT_THAT(found[1].files, IsEmpty());
}

}  // namespace
}  // namespace latchwork::plugin

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/plugin/registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "tests/core/plugin/plugin_folders.h"
#include "tests/temporary_folder.h"

namespace latchwork::plugin {
namespace {

using std::filesystem::path;
using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Registry RegistryOf(const TemporaryFolder& folder) { return Registry({folder.path()}); }

/// Whether a file is mapped into this process, that is, loaded.
bool IsMapped(const path& file) {
  std::ifstream maps("/proc/self/maps");
  const std::string text{std::istreambuf_iterator<char>(maps), std::istreambuf_iterator<char>()};
  return text.find(file.string()) != std::string::npos;
}

TEST(RegistryTest, ThePluginsNameIsTheRecords) {
  const TemporaryFolder folder;
  folder.Copy(kSamples / "plain.so", "some_file.so");
  const Registry registry = RegistryOf(folder);
  ASSERT_THAT(registry.List(), SizeIs(1));
  EXPECT_EQ(registry.List()[0].name, "sample");
  EXPECT_EQ(registry.List()[0].version, "1.2");
  EXPECT_THAT(registry.List()[0].problem, IsEmpty());
  EXPECT_THAT(registry.Names(sdk::PluginKind::kReasoner), ElementsAre("sample"));
  EXPECT_THAT(registry.Names(sdk::PluginKind::kLayer), IsEmpty());
  EXPECT_TRUE(registry.MakeReasoner("sample").object);
}

TEST(RegistryTest, KindsHaveNamesOfTheirOwn) {
  const TemporaryFolder folder;
  folder.Copy(kSamples / "plain.so", "a.so");
  folder.Copy(kSamples / "layer.so", "b.so");
  const Registry registry = RegistryOf(folder);
  const Made<sdk::Reasoner> reasoner = registry.MakeReasoner("sample");
  const Made<sdk::Layer> layer = registry.MakeLayer("sample");
  ASSERT_TRUE(reasoner.object) << reasoner.error;
  ASSERT_TRUE(layer.object) << layer.error;
  EXPECT_THAT(layer.object->languages(), ElementsAre("sample"));
  EXPECT_EQ(registry.MakeWorld("sample").failure, MakeFailure::kUnknownName);
}

TEST(RegistryTest, UnknownName_GivesTheNearestAndWhatWasSearched) {
  const TemporaryFolder folder;
  folder.Copy(kSamples / "plain.so", "plain.so");
  const Registry registry({folder.path(), folder.path() / "none"});
  const Made<sdk::Reasoner> made = registry.MakeReasoner("sampel");
  EXPECT_EQ(made.failure, MakeFailure::kUnknownName);
  EXPECT_EQ(made.error, "there is no reasoner plugin 'sampel', did you mean 'sample'?; searched: " +
                            folder.path().string() + ", " + (folder.path() / "none").string() +
                            " (No such file or directory)");
}

TEST(RegistryTest, EmptySearchPath_SaysSo) {
  const Registry registry(std::vector<path>{});
  EXPECT_THAT(registry.List(), IsEmpty());
  EXPECT_THAT(registry.MakeWorld("office").error, HasSubstr("searched: no folder"));
}

/// Loads marks_loading in one of its builds and says whether code of it ran.
bool RunsCode(const char* sample, Made<sdk::Reasoner>& made) {
  const TemporaryFolder folder;
  const path marker = folder.path() / "marker";
  folder.Copy(kSamples / sample, "marks_loading.so");
  setenv("LATCHWORK_TEST_MARKER", marker.c_str(), 1);
  made = RegistryOf(folder).MakeReasoner("marks_loading");
  unsetenv("LATCHWORK_TEST_MARKER");
  return std::filesystem::exists(marker);
}

TEST(RegistryTest, AbiMismatch_IsRefusedBeforeAnyCodeRuns) {
  Made<sdk::Reasoner> made;
  ASSERT_TRUE(RunsCode("marks_loading.so", made)) << "the marker must show what does run";
  ASSERT_TRUE(made.object) << made.error;
  EXPECT_FALSE(RunsCode("marks_loading_wrong_abi.so", made));
  EXPECT_FALSE(made.object);
  EXPECT_EQ(made.failure, MakeFailure::kUnusable);
  EXPECT_THAT(made.error, AllOf(HasSubstr("marks_loading.so"),
                                HasSubstr("built for plugin ABI " + std::to_string(sdk::kAbi + 1)),
                                HasSubstr("rebuild it against these headers")));
}

struct Broken {
  const char* sample;
  const char* reason;
};

void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.sample; }

class BrokenPluginTest : public testing::TestWithParam<Broken> {};

TEST_P(BrokenPluginTest, GivesPathReasonAndWhatWasSearched) {
  const TemporaryFolder folder;
  const path file = folder.Copy(kSamples / (std::string(GetParam().sample) + ".so"), "broken.so");
  const Made<sdk::Reasoner> made = RegistryOf(folder).MakeReasoner(GetParam().sample);
  EXPECT_FALSE(made.object);
  EXPECT_EQ(made.failure, MakeFailure::kUnusable);
  EXPECT_THAT(made.error, AllOf(HasSubstr(file.string() + ": "), HasSubstr(GetParam().reason),
                                HasSubstr("searched: " + folder.path().string())));
}

INSTANTIATE_TEST_SUITE_P(
    All, BrokenPluginTest,
    testing::Values(Broken{"no_create", "undefined symbol: latchwork_plugin_create"},
                    Broken{"null_create", "latchwork_plugin_create gave null"},
                    Broken{"unresolved", "undefined symbol: latchwork_defined_nowhere"}),
    [](const auto& instance) { return std::string(instance.param.sample); });

TEST(RegistryTest, FileWithoutRecord_GoesByItsFileNameAndGivesTheReason) {
  const TemporaryFolder folder;
  folder.Write("seek.so", "not a library");
  const Registry registry = RegistryOf(folder);
  ASSERT_THAT(registry.List(), SizeIs(1));
  EXPECT_EQ(registry.List()[0].name, "seek");
  EXPECT_FALSE(registry.List()[0].info);
  EXPECT_THAT(registry.List()[0].problem, HasSubstr("no shared library"));
  const Made<sdk::Layer> made = registry.MakeLayer("seek");
  EXPECT_EQ(made.failure, MakeFailure::kUnusable);
  EXPECT_THAT(made.error,
              HasSubstr((folder.path() / "seek.so").string() + ": is no shared library"));
}

TEST(RegistryTest, TwoFilesOfOneName_AreRefusedWithBothPaths) {
  const TemporaryFolder first;
  const TemporaryFolder second;
  const path a = first.Copy(kSamples / "plain.so", "a.so");
  const path b = second.Copy(kSamples / "plain.so", "b.so");
  const Registry registry({first.path(), second.path()});
  const Made<sdk::Reasoner> made = registry.MakeReasoner("sample");
  EXPECT_EQ(made.failure, MakeFailure::kUnusable);
  EXPECT_THAT(made.error, HasSubstr("ambiguous: " + a.string() + " and " + b.string()));
  EXPECT_THAT(registry.Names(sdk::PluginKind::kReasoner), IsEmpty());
  EXPECT_THAT(registry.List()[0].problem, HasSubstr(b.string()));
  EXPECT_THAT(registry.List()[1].problem, HasSubstr(a.string()));
  EXPECT_EQ(registry.DataFolder(sdk::PluginKind::kReasoner, "sample"), path());
}

TEST(RegistryTest, OneFileReachedTwice_IsNotAmbiguous) {
  const TemporaryFolder first;
  const TemporaryFolder second;
  const path file = first.Copy(kSamples / "plain.so", "a.so");
  std::filesystem::create_symlink(file, second.path() / "b.so");
  const Registry registry({first.path(), second.path()});
  EXPECT_TRUE(registry.MakeReasoner("sample").object);
}

TEST(RegistryTest, ObjectOutlivesTheRegistry_AndTheLibraryGoesWithTheLastObject) {
  const TemporaryFolder folder;
  const path file = folder.Copy(kSamples / "plain.so", "short_lived.so");
  std::optional<Registry> registry(std::in_place, std::vector<path>{folder.path()});
  EXPECT_FALSE(IsMapped(file)) << "listing must not load";
  std::shared_ptr<sdk::Reasoner> one = registry->MakeReasoner("sample").object;
  std::shared_ptr<sdk::Reasoner> two = registry->MakeReasoner("sample").object;
  ASSERT_TRUE(one);
  ASSERT_TRUE(two);
  registry.reset();
  one.reset();
  EXPECT_TRUE(IsMapped(file));
  EXPECT_THAT(two->parameters(), SizeIs(1));
  two.reset();
  EXPECT_FALSE(IsMapped(file));
}

TEST(RegistryTest, DataFolder_StandsBesideTheLibraryUnderThePluginsName) {
  const TemporaryFolder folder;
  folder.Copy(kSamples / "plain.so", "file.so");
  const Registry registry = RegistryOf(folder);
  EXPECT_EQ(registry.DataFolder(sdk::PluginKind::kReasoner, "sample"), folder.path() / "sample");
  EXPECT_EQ(registry.DataFolder(sdk::PluginKind::kWorld, "sample"), path());
}

TEST(RegistryTest, Fingerprint_IsOfTheBytes) {
  const TemporaryFolder first;
  const TemporaryFolder second;
  const TemporaryFolder third;
  first.Copy(kSamples / "plain.so", "a.so");
  second.Copy(kSamples / "plain.so", "b.so");
  third.Copy(kSamples / "stripped.so", "a.so");
  const auto fingerprint = [](const TemporaryFolder& folder) {
    return RegistryOf(folder).Fingerprint(sdk::PluginKind::kReasoner, "sample");
  };
  EXPECT_THAT(fingerprint(first), SizeIs(16));
  EXPECT_EQ(fingerprint(first), fingerprint(second));
  EXPECT_NE(fingerprint(first), fingerprint(third));
  EXPECT_THAT(RegistryOf(first).Fingerprint(sdk::PluginKind::kLayer, "sample"), IsEmpty());
}

TEST(RegistryTest, List_IsInTheOrderOfTheSearchPathAndThenOfNames) {
  const Registry registry({kFaults});
  std::vector<std::string> names;
  for (const PluginEntry& entry : registry.List()) names.push_back(entry.name);
  EXPECT_THAT(names, ElementsAre("bad_facts", "ends", "ends_on_loading", "forgetful", "hangs",
                                 "inconsistent", "over_budget", "returns_nan", "silent",
                                 "starts_a_thread", "throws", "wrong_abi"));
}

}  // namespace
}  // namespace latchwork::plugin

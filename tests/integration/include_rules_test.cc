// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/include_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace latchwork::tests {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::vector<SourceFile>& Tree() {
  static const std::vector<SourceFile> tree = ReadTree(LATCHWORK_SOURCE_DIR);
  return tree;
}

template <typename Check>
Findings OverTree(const Check& check) {
  Findings all;
  for (const SourceFile& file : Tree()) {
    const Findings findings = check(file);
    all.insert(all.end(), findings.begin(), findings.end());
  }
  return all;
}

Findings Dependencies(const std::string& path, const std::string& include) {
  return CheckDependencies({path, "#include \"" + include + "\"\n"});
}

Findings Confinements(const std::string& path, const std::string& include) {
  return CheckConfinement({path, "#include <" + include + ">\n"});
}

TEST(IncludeRulesTest, TreeDependsInOneDirection) {
  EXPECT_THAT(OverTree(CheckDependencies), IsEmpty());
}

TEST(IncludeRulesTest, TreeConfinesTheLibrariesOfOthers) {
  EXPECT_THAT(OverTree(CheckConfinement), IsEmpty());
  EXPECT_THAT(CheckSingleUsers(Tree()), IsEmpty());
}

TEST(IncludeRulesTest, TreeKeepsTheFormOfFiles) {
  EXPECT_THAT(OverTree(CheckForm), IsEmpty());
  EXPECT_THAT(CheckGuardsDiffer(Tree()), IsEmpty());
}

TEST(IncludeRulesTest, ReadTreeFindsSourcesAndHeaders) {
  const auto has = [](const std::string& path) {
    return std::ranges::any_of(Tree(), [&](const SourceFile& file) { return file.path == path; });
  };
  EXPECT_TRUE(has("core/include/latchwork/sdk/plugin.h"));
  EXPECT_TRUE(has("tests/integration/include_rules.cc"));
}

TEST(IncludeRulesTest, UpwardIncludeInCore_IsFound) {
  EXPECT_THAT(Dependencies("core/logic/term.cc", "latchwork/sdk/layer.h"),
              ElementsAre("core/logic/term.cc:1: may not include latchwork/sdk/layer.h"));
  EXPECT_THAT(Dependencies("core/include/latchwork/sdk/layer.h", "latchwork/config/agent.h"),
              SizeIs(1));
  EXPECT_THAT(Dependencies("core/config/reader.cc", "core/plugin/loader.h"), SizeIs(1));
  EXPECT_THAT(Dependencies("core/record/journal.cc", "apps/latchwork/run.h"), SizeIs(1));
}

TEST(IncludeRulesTest, DownwardIncludeInCore_IsFine) {
  EXPECT_THAT(Dependencies("core/schedule/tick.cc", "latchwork/config/agent.h"), IsEmpty());
  EXPECT_THAT(Dependencies("core/logic/term.cc", "core/logic/print.h"), IsEmpty());
  EXPECT_THAT(Dependencies("apps/latchwork/run.cc", "latchwork/record/journal.h"), IsEmpty());
}

TEST(IncludeRulesTest, PluginThatSeesMoreThanLogicAndSdk_IsFound) {
  EXPECT_THAT(Dependencies("plugins/avoid/force.cc", "latchwork/sdk/attachment.h"), IsEmpty());
  EXPECT_THAT(Dependencies("plugins/avoid/force.cc", "plugins/avoid/force.h"), IsEmpty());
  EXPECT_THAT(Dependencies("plugins/avoid/force.cc", "plugins/seek/force.h"), SizeIs(1));
  EXPECT_THAT(Dependencies("plugins/avoid/force.cc", "reasoners/pttp/strategies/prover.h"),
              SizeIs(1));
  EXPECT_THAT(Dependencies("worlds/office/map.cc", "latchwork/schedule/latch.h"), SizeIs(1));
}

TEST(IncludeRulesTest, IncludeOfTests_IsFoundOutsideThem) {
  EXPECT_THAT(Dependencies("core/logic/term.cc", "tests/core/logic/fixture.h"), SizeIs(1));
  EXPECT_THAT(Dependencies("tests/core/logic/term_test.cc", "tests/core/logic/fixture.h"),
              IsEmpty());
}

TEST(IncludeRulesTest, IncludeByPathUpwards_IsFound) {
  EXPECT_THAT(Dependencies("core/logic/term.cc", "../sdk/layer.h"), SizeIs(1));
}

TEST(IncludeRulesTest, ConfinedLibraryElsewhere_IsFound) {
  EXPECT_THAT(Confinements("worlds/office/map.cc", "mrpt/maps/COccupancyGridMap2D.h"), IsEmpty());
  EXPECT_THAT(Confinements("plugins/avoid/force.cc", "mrpt/poses/CPose2D.h"), SizeIs(1));
  EXPECT_THAT(Confinements("core/config/xml.cc", "xercesc/sax2/SAX2XMLReader.hpp"), IsEmpty());
  EXPECT_THAT(Confinements("core/logic/term.cc", "fmt/format.h"), SizeIs(1));
  EXPECT_THAT(Confinements("core/include/latchwork/config/xml.h", "fmt/format.h"), SizeIs(1));
  EXPECT_THAT(Confinements("apps/latchwork/run.cc", "gtest/gtest.h"), SizeIs(1));
}

TEST(IncludeRulesTest, SecondUserOfAHiddenLibrary_IsFound) {
  const SourceFile first{"core/config/a.cc", "#include <xercesc/dom/DOM.hpp>\n"};
  const SourceFile second{"core/config/b.cc", "#include <xercesc/dom/DOM.hpp>\n"};
  EXPECT_THAT(CheckSingleUsers({first}), IsEmpty());
  EXPECT_THAT(CheckSingleUsers({first, second}), SizeIs(1));
}

TEST(IncludeRulesTest, BadForm_IsFound) {
  const std::string spdx = "// SPDX-License-Identifier: BSD-3-Clause\n";
  const std::string guard = "#ifndef LATCHWORK_LOGIC_TERM_H_\n#define LATCHWORK_LOGIC_TERM_H_\n";
  EXPECT_THAT(CheckForm({"core/logic/term.h", spdx + guard}), IsEmpty());
  EXPECT_THAT(CheckForm({"core/logic/term.h", guard}), SizeIs(1));
  EXPECT_THAT(CheckForm({"core/logic/atom.h", spdx + guard}), SizeIs(1));
  EXPECT_THAT(CheckForm({"core/logic/term.h", spdx}), SizeIs(1));
  EXPECT_THAT(CheckForm({"core/logic/term.cc", spdx + std::string(600, '\n')}), SizeIs(1));
}

TEST(IncludeRulesTest, SharedGuard_IsFound) {
  const std::string guard = "#ifndef LATCHWORK_TERM_H_\n#define LATCHWORK_TERM_H_\n";
  const SourceFile first{"core/logic/term.h", guard};
  const SourceFile second{"core/sdk/term.h", guard};
  EXPECT_THAT(CheckGuardsDiffer({first, second}), SizeIs(1));
}

}  // namespace
}  // namespace latchwork::tests

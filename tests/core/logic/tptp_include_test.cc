// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "latchwork/logic/tptp.h"

namespace latchwork::logic {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class TptpIncludeTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("latchwork_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "axioms");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void Write(const std::string& name, std::string_view text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  std::vector<std::string> Names(const TptpFile& file) {
    std::vector<std::string> names;
    for (const auto& formula : file.formulas) names.push_back(formula.name);
    return names;
  }

  fs::path folder_;
  SymbolTable symbols_;
};

TEST_F(TptpIncludeTest, Include_ExpandsInPlace) {
  Write("main.p", "fof(a, axiom, p).\ninclude('axioms/more.ax').\nfof(c, axiom, p).");
  Write("axioms/more.ax", "fof(b, axiom, p).\ninclude('deep.ax').");
  Write("axioms/deep.ax", "fof(d, axiom, p).");
  const TptpFile file = ReadTptpFile(folder_ / "main.p", symbols_);
  EXPECT_THAT(Format(file.diagnostics), IsEmpty());
  EXPECT_THAT(Names(file), ElementsAre("a", "b", "d", "c"));
  EXPECT_EQ(file.formulas[1].place.file, (folder_ / "axioms/more.ax").string());
}

TEST_F(TptpIncludeTest, Selection_KeepsNamedFormulas) {
  Write("main.p", "include('ax.p', [b, 'C c']). include('ax.p', *). include('ax.p', [], x).");
  Write("ax.p", "fof(a, axiom, p). fof(b, axiom, p). fof('C c', axiom, p).");
  const TptpFile file = ReadTptpFile(folder_ / "main.p", symbols_);
  EXPECT_THAT(Format(file.diagnostics), IsEmpty());
  EXPECT_THAT(Names(file), ElementsAre("b", "C c", "a", "b", "C c"));
}

TEST_F(TptpIncludeTest, SelectionOfUnknownName_IsReported) {
  Write("main.p", "include('ax.p', [b]).");
  Write("ax.p", "fof(a, axiom, p).");
  const TptpFile file = ReadTptpFile(folder_ / "main.p", symbols_);
  ASSERT_THAT(file.diagnostics, SizeIs(1));
  EXPECT_THAT(file.diagnostics[0].message, HasSubstr("no formula named 'b'"));
}

TEST_F(TptpIncludeTest, IncludeRoot_IsTriedSecond) {
  Write("main.p", "include('only_there.ax').");
  Write("axioms/only_there.ax", "fof(a, axiom, p).");
  TptpOptions options;
  options.include_root = folder_ / "axioms";
  EXPECT_THAT(Names(ReadTptpFile(folder_ / "main.p", symbols_, options)), ElementsAre("a"));
  options.include_root = folder_ / "nowhere";
  const TptpFile file = ReadTptpFile(folder_ / "main.p", symbols_, options);
  ASSERT_THAT(file.diagnostics, SizeIs(1));
  EXPECT_THAT(file.diagnostics[0].hint, HasSubstr("nowhere"));
}

TEST_F(TptpIncludeTest, Circle_IsRefused) {
  Write("a.p", "include('b.p').");
  Write("b.p", "fof(b, axiom, p).\n include('./a.p').");
  const TptpFile file = ReadTptpFile(folder_ / "a.p", symbols_);
  ASSERT_THAT(file.diagnostics, SizeIs(1));
  EXPECT_THAT(file.diagnostics[0].message, HasSubstr("includes itself"));
  EXPECT_EQ(file.diagnostics[0].place.line, 2U);
}

TEST_F(TptpIncludeTest, Doubling_IsBounded) {
  for (int i = 0; i < 30; ++i) {
    const std::string next = "include('f" + std::to_string(i + 1) + ".p').\n";
    Write("f" + std::to_string(i) + ".p", next + next);
  }
  Write("f30.p", "fof(a, axiom, p).");
  const TptpFile file = ReadTptpFile(folder_ / "f0.p", symbols_);
  ASSERT_FALSE(file.diagnostics.empty());
  EXPECT_THAT(file.diagnostics[0].message, HasSubstr("too many includes"));
}

TEST_F(TptpIncludeTest, FaultsInside_NameTheirOwnFile) {
  Write("main.p", "include('ax.p').\nfof(a, axiom, ).");
  Write("ax.p", "\nfof(b, axiom, ).");
  const TptpFile file = ReadTptpFile(folder_ / "main.p", symbols_);
  ASSERT_THAT(file.diagnostics, SizeIs(2));
  EXPECT_EQ(file.diagnostics[0].place.file, (folder_ / "ax.p").string());
  EXPECT_EQ(file.diagnostics[1].place.file, (folder_ / "main.p").string());
}

TEST_F(TptpIncludeTest, TooLargeFile_IsRefused) {
  Write("main.p", "fof(a, axiom, p). fof(b, axiom, p).");
  TptpOptions options;
  options.max_bytes = 20;
  const TptpFile file = ReadTptpFile(folder_ / "main.p", symbols_, options);
  ASSERT_THAT(file.diagnostics, SizeIs(1));
  EXPECT_THAT(file.diagnostics[0].message, HasSubstr("20 bytes"));
}

}  // namespace
}  // namespace latchwork::logic

// SPDX-License-Identifier: BSD-3-Clause
#include "core/plugin/abi_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace latchwork::plugin {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

sdk::PluginInfo Fitting() {
  return sdk::MakePluginInfo(sdk::PluginKind::kWorld, "office-2", "1.0", "a world");
}

TEST(AbiCheckTest, RecordOfThisBuild_Fits) { EXPECT_THAT(AbiDifferences(Fitting()), IsEmpty()); }

TEST(AbiCheckTest, AnotherAbi_SaysWhichAndHowToMendIt) {
  sdk::PluginInfo info = Fitting();
  info.abi = sdk::kAbi + 1;
  EXPECT_THAT(AbiDifferences(info),
              ElementsAre("built for plugin ABI " + std::to_string(sdk::kAbi + 1) +
                          ", this latchwork speaks " + std::to_string(sdk::kAbi) +
                          ": rebuild it against these headers"));
}

TEST(AbiCheckTest, AnotherMagic_SaysNothingElse) {
  sdk::PluginInfo info{};
  EXPECT_THAT(AbiDifferences(info), ElementsAre(HasSubstr("magic number")));
  EXPECT_FALSE(HasKnownLayout(info));
}

TEST(AbiCheckTest, AnotherSize_SaysNothingOfTheFieldsAfterIt) {
  sdk::PluginInfo info = Fitting();
  info.size -= 8;
  info.cxx = 0;
  EXPECT_THAT(AbiDifferences(info), ElementsAre(HasSubstr("has 400 bytes")));
  EXPECT_FALSE(HasKnownLayout(info));
}

TEST(AbiCheckTest, AnotherCompilerMajor_Differs) {
  sdk::PluginInfo info = Fitting();
  info.compiler = sdk::FixedText<64>("gcc 4.8.5");
  EXPECT_THAT(AbiDifferences(info), ElementsAre(HasSubstr("the compiler 'gcc 4', this latchwork")));
}

TEST(AbiCheckTest, AnotherCompilerMinor_Fits) {
  sdk::PluginInfo info = Fitting();
  const std::string here = info.compiler.data();
  info.compiler = sdk::FixedText<64>(here.substr(0, here.find('.')) + ".99.1");
  EXPECT_THAT(AbiDifferences(info), IsEmpty());
}

TEST(AbiCheckTest, EverythingElseThatDiffers_IsListedAtOnce) {
  sdk::PluginInfo info = Fitting();
  info.kind = static_cast<sdk::PluginKind>(7);
  info.cxx = 201703;
  info.stdlib = sdk::FixedText<32>("libc++");
  info.sanitizers = sdk::FixedText<32>("memory");
  info.name = sdk::FixedText<64>("../../etc");
  EXPECT_THAT(AbiDifferences(info),
              ElementsAre("of the unknown kind 7", HasSubstr("C++ standard '201703'"),
                          HasSubstr("standard library 'libc++'"), HasSubstr("sanitizers 'memory'"),
                          HasSubstr("named '../../etc'")));
}

}  // namespace
}  // namespace latchwork::plugin
